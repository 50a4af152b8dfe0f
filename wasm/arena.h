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

/* Takes `count` items of `item_bytes` bytes, aligned to 16 bytes, contents undefined. NULL when they do not fit: the caller answers
 * SP_OUT_OF_MEMORY. What has refused once refuses everything from then on, its size 0: a solve that would try something smaller instead
 * ends as out of memory, too, and not as another path. */
void *sp_arena_take(struct sp_arena *arena, size_t count, size_t item_bytes);

#endif
