/* The memory of a WebAssembly instance: malloc and free for JavaScript alone, which keeps few blocks of any size. The first block that is
 * large enough is taken; free ones lie in a list in the order of their addresses, neighbours made one, so that a block is found or given
 * back in time proportional to their number. Native builds have their own. */
#ifdef __wasm__
#include <stddef.h>
#include <stdint.h>

enum { PAGE = 65536 };

/* Before every block: its size in bytes with this head, a multiple of 16; of a free one, the next. Pages end, and so blocks begin, at
 * multiples of 16. */
struct head {
    size_t size;
    struct head *next;
};

extern struct head __heap_base; /* where the linker's data and stack end */

static struct head *first;
static char *end;

void *malloc(size_t bytes);
void free(void *block);

/* More memory, of at least `size` bytes from the last free block on. Returns 0 if there is none. */
static int grow(size_t size) {
    if (!end) {
        end = (char *)(((size_t)&__heap_base + 15) & ~(size_t)15);
    } else if (__builtin_wasm_memory_grow(0, (size + PAGE - 1) / PAGE) == SIZE_MAX) {
        return 0;
    }
    struct head *block = (struct head *)end;
    end = (char *)(__builtin_wasm_memory_size(0) * PAGE);
    block->size = (size_t)(end - (char *)block);
    free(block + 1);
    return 1;
}

/* `bytes` bytes aligned to 8; NULL if memory is exhausted. */
void *malloc(size_t bytes) {
    size_t size = (bytes + sizeof(struct head) + 15) & ~(size_t)15;
    if (size < bytes) return NULL;
    for (;;) {
        size_t last = 0;
        for (struct head **at = &first; *at; at = &(*at)->next) {
            struct head *block = *at;
            last = (char *)block + block->size == end ? block->size : 0;
            if (block->size < size) continue;
            *at = block->next;
            if (block->size > size) {
                struct head *rest = (struct head *)((char *)block + size);
                rest->size = block->size - size, rest->next = block->next;
                *at = rest, block->size = size;
            }
            return block + 1;
        }
        if (!grow(size - last)) return NULL;
    }
}

/* Gives a block of malloc back. */
void free(void *block) {
    struct head *freed = (struct head *)block - 1, *before = NULL, *after = first;
    for (; after && after < freed; after = after->next)
        before = after;
    if ((char *)freed + freed->size == (char *)after) freed->size += after->size, after = after->next;
    freed->next = after;
    if (before && (char *)before + before->size == (char *)freed)
        before->size += freed->size, before->next = after;
    else if (before)
        before->next = freed;
    else
        first = freed;
}
#endif
