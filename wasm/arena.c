/* Taking from the arena, the one place that refuses. */
#include "arena.h"

void *sp_arena_take(struct sp_arena *arena, size_t count, size_t item_bytes) {
    size_t left = arena->size > arena->used ? (arena->size - arena->used) & ~(size_t)15 : 0;
    if (item_bytes != 0 && count > left / item_bytes) return arena->size = 0, NULL;
    void *taken = arena->base + arena->used;
    arena->used += (count * item_bytes + 15) & ~(size_t)15;
    return taken;
}
