/**
 * The bytes behind an inlined text. Text costs a third more than bytes, and compressing text again does not win it back: so the bytes are compressed first, each
 * kind by itself, as wasm/pack/regroup.c tells them apart.
 */

/** Kinds of bytes; and where in the memory of regroup.c there is room: behind its stack. */
export const [KINDS, FIRST] = [8, 65536];

/** @param {string} text base64 */
function decode(text) {
  // A fiftieth of the time, in Node.
  if (globalThis.Buffer) return Buffer.from(text, 'base64');
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  // Half the time of Uint8Array.from in a cold process.
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** @param {Uint8Array<ArrayBuffer>} packed gzip data */
async function decompress(packed) {
  // Where there is zlib, it takes 5 ms of a cold process, and the stream 15.
  const zlib = globalThis.process?.getBuiltinModule?.('node:zlib');
  if (zlib) return new Uint8Array(zlib.gunzipSync(packed));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * The module that wasm/pack/pack.js packed.
 * @param {string} text base64 of gzip data: lengths, 32 bits each, of what follows; the module that was made from regroup.c; the heaps, one after the other
 */
export async function unpack(text) {
  const bytes = await decompress(decode(text));
  const [regrouper, ...lengths] = new Uint32Array(bytes.buffer, 0, 1 + KINDS);
  const code = 4 + 4 * KINDS;
  const heaps = bytes.subarray(code + regrouper);
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(bytes.subarray(code, code + regrouper)));
  const { memory, regroup } = /** @type {{ memory: WebAssembly.Memory, regroup: Function }} */ (/** @type {unknown} */ (exports));
  memory.grow(1 + ((2 * bytes.length) >> 16));
  /* One behind the other: where each heap is read next, the heaps, the module. */
  const first = FIRST + 4 * KINDS;
  const module = first + heaps.length;
  const next = new Uint32Array(memory.buffer, FIRST, KINDS);
  for (let kind = 0, at = first; kind < KINDS; at += lengths[kind++]) next[kind] = at;
  new Uint8Array(memory.buffer).set(heaps, first);
  regroup(module, heaps.length, FIRST, 0);
  return new Uint8Array(memory.buffer, module, heaps.length);
}
