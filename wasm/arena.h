/* Scratch memory handed in by the caller: the core's only source of memory. Taken from the front, given back all at once. */
#ifndef SURFPATH_ARENA_H
#define SURFPATH_ARENA_H

#include <stddef.h>
#include <stdint.h>

struct sp_arena {
    char *base;  /* aligned to 16 bytes */
    size_t size; /* bytes */
    size_t used; /* bytes from base that are taken; a multiple of 16 */
};

/* Takes `count` items of `item_bytes` bytes, aligned to 16 bytes, contents undefined. NULL when they do not fit: the arena is then
 * unchanged and the caller answers SP_OUT_OF_MEMORY. */
static inline void *sp_arena_take(struct sp_arena *arena, size_t count, size_t item_bytes) {
    size_t left = (arena->size - arena->used) & ~(size_t)15;
    if (item_bytes != 0 && count > left / item_bytes) return NULL;
    void *taken = arena->base + arena->used;
    arena->used += (count * item_bytes + 15) & ~(size_t)15;
    return taken;
}

#endif
