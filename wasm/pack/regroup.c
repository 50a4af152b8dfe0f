/* Moves the bytes of a WebAssembly module to heaps by their kind, and back: put together, bytes of one kind compress better than as they
 * stand. What is looked at are only bytes that have been moved, so one walk takes a module apart (pack.js) and puts it together
 * (web/runtime/unpack.js). It knows what our build makes; of another module it would find other kinds, and still put it together.
 *
 * A module of its own, which travels with the one it unpacks: in JavaScript, which a fresh process interprets, this took 7 ms, a quarter of
 * all loading. */
#include <stdint.h>

/* Kinds: whatever else; opcodes and forms of instructions; locals read, and written; constant integers; offsets of addresses; functions
 * called; types of locals. Then what else follows an opcode: nothing; a number of 4 or 8 bytes; a vector instruction. */
enum kind { OTHER, FORM, READ, WRITTEN, INTEGER, OFFSET, CALLED, DECLARED, NOTHING, FLOAT, DOUBLE, VECTOR };

enum { HEADER = 8, CODE_SECTION = 10, LANES = 16 };

struct walk {
    uint8_t *at, **next; /* in the module; in the heap of each kind */
    int apart;           /* from the module to the heaps; else from the heaps to the module */
};

/* Moves the next byte, and returns it. */
static uint8_t move(struct walk *walk, enum kind kind) {
    uint8_t *module = walk->at++, *heap = walk->next[kind]++;
    return walk->apart ? (*heap = *module) : (*module = *heap);
}

static void move_bytes(struct walk *walk, enum kind kind, uint32_t count) {
    while (count-- > 0)
        move(walk, kind);
}

/* An integer, LEB128; its lower 32 bits. */
static uint32_t move_integer(struct walk *walk, enum kind kind) {
    uint32_t value = 0;
    for (uint32_t shift = 0;; shift += 7) {
        uint8_t part = move(walk, kind);
        if (shift < 32) value |= (uint32_t)(part & 127) << shift;
        if (part < 128) return value;
    }
}

/* What follows an opcode: an integer of a kind (OFFSET: with an alignment before it), or what the kinds from NOTHING on say. */
static enum kind operand_of(uint8_t opcode) {
    switch (opcode) {
    case 0x02: /* block, loop, if */
    case 0x03:
    case 0x04:
    case 0x0c: /* br, br_if */
    case 0x0d:
    case 0x23: /* global.get, global.set */
    case 0x24:
    case 0xfc: /* conversions, copies of memory */
        return FORM;
    case 0x10: /* call, call_indirect */
    case 0x11:
        return CALLED;
    case 0x20:
        return READ;
    case 0x21: /* local.set, local.tee */
    case 0x22:
        return WRITTEN;
    case 0x41:
        return INTEGER;
    case 0x43:
        return FLOAT;
    case 0x44:
        return DOUBLE;
    case 0xfd:
        return VECTOR;
    }
    if (opcode >= 0x28 && opcode <= 0x3e) return OFFSET;
    return opcode >= 0x3f && opcode <= 0x42 ? OTHER : NOTHING;
}

static void move_instruction(struct walk *walk) {
    enum kind operand = operand_of(move(walk, FORM));
    if (operand == VECTOR) {
        uint32_t number = move_integer(walk, FORM);
        if (number > 20 && number < 35) move(walk, FORM); /* a lane */
        if (number == 12 || number == 13) move_bytes(walk, OTHER, LANES);
        operand = number > 11 ? NOTHING : OFFSET;
    }
    if (operand == NOTHING) return;
    if (operand > NOTHING) {
        move_bytes(walk, OTHER, operand == FLOAT ? 4 : 8);
        return;
    }
    if (operand == OFFSET) move(walk, FORM);
    move_integer(walk, operand);
}

static void move_function(struct walk *walk) {
    uint32_t size = move_integer(walk, OTHER);
    uint8_t *end = walk->at + size;
    for (uint32_t groups = move_integer(walk, DECLARED); groups > 0; groups--)
        move_bytes(walk, DECLARED, 2);
    while (walk->at < end)
        move_instruction(walk);
}

/* Moves a module of `length` bytes from one side to the other. next: of each kind, where its heap begins; afterwards, where it ends. */
void regroup(uint8_t *module, uint32_t length, uint8_t **next, int apart) {
    struct walk walk = {module, next, apart};
    move_bytes(&walk, OTHER, HEADER);
    while (walk.at < module + length) {
        uint8_t section = move(&walk, OTHER);
        uint32_t size = move_integer(&walk, OTHER);
        if (section != CODE_SECTION)
            move_bytes(&walk, OTHER, size);
        else
            for (uint32_t count = move_integer(&walk, OTHER); count > 0; count--)
                move_function(&walk);
    }
}
