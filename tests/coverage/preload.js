/**
 * Loaded before a test file by `node --import`: gives every use of dist/surfpath.wasm its instrumented twin instead, and at exit writes the
 * counters of all instances to build/coverage/counters/, as JSON by name and structure hash. The tests notice nothing but the time.
 */
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { threadId } from 'node:worker_threads';

const file = (/** @type {string} */ path) => new URL(`../../${path}`, import.meta.url);
const original = readFileSync(file('dist/surfpath.wasm'));
const instrumented = readFileSync(file('build/coverage/surfpath.wasm'));
const counters = file('build/coverage/counters/');
/** As many instances are kept alive; the counters of earlier ones are read before they are let go. */
const MOST_ALIVE = 32;

/** @type {Record<string, any>[]} */
const alive = [];
/** Sums by `structure hash` and name. @type {Map<string, number[]>} */
const sums = new Map();

const { Module, Instance, compile } = WebAssembly;

/** @param {BufferSource} bytes */
function exchange(bytes) {
  const view = ArrayBuffer.isView(bytes) ? Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength) : Buffer.from(bytes);
  return original.equals(view) ? instrumented : bytes;
}

WebAssembly.Module = new Proxy(Module, { construct: (target, [bytes]) => new target(exchange(bytes)) });
WebAssembly.compile = (bytes) => compile(exchange(bytes));
WebAssembly.Instance = new Proxy(Instance, {
  // A test may make a class of it, which hides some of the exports.
  construct(target, given, made) {
    const instance = Reflect.construct(target, given, made);
    const exports = /** @type {any} */ (Reflect.get(target.prototype, 'exports', instance));
    if (typeof exports.coverage_functions === 'function') {
      /* Functions tell the counters of themselves; the module without counters has nothing to begin with. */
      exports._initialize();
      remember(exports);
    }
    return instance;
  },
});

/** @param {Record<string, any>} exports */
function remember(exports) {
  alive.push(exports);
  if (alive.length > MOST_ALIVE) read(/** @type {any} */ (alive.shift()));
}

/** Adds the counters of an instance to the sums. @param {Record<string, any>} exports */
function read(exports) {
  const memory = exports.memory.buffer;
  const names = namesByHash(exports);
  const [functions, count] = [exports.coverage_functions(), exports.coverage_function_count()];
  for (let i = 0; i < count; i++) {
    const [nameHash, structureHash] = new BigUint64Array(memory, functions + 24 * i, 2);
    const [at, length] = new Uint32Array(memory, functions + 24 * i + 16, 2);
    const key = `${structureHash} ${names.get(nameHash)}`;
    const sum = sums.get(key) ?? new Array(length).fill(0);
    new BigUint64Array(memory, at, length).forEach((n, k) => {
      sum[k] += Number(n);
    });
    sums.set(key, sum);
  }
}

/** @param {Record<string, any>} exports */
function namesByHash(exports) {
  const memory = exports.memory.buffer;
  /** @type {Map<bigint, string>} */
  const names = new Map();
  const blocks = new Uint32Array(memory, exports.coverage_names(), 2 * exports.coverage_name_count());
  for (let i = 0; i < blocks.length; i += 2) {
    for (const name of readNames(Buffer.from(memory, blocks[i], blocks[i + 1])))
      names.set(createHash('md5').update(name).digest().readBigUInt64LE(), name);
  }
  return names;
}

/** Chunks of: uncompressed length and 0 for "not compressed", both LEB128, then names separated by 1. @param {Buffer} bytes */
function readNames(bytes) {
  let at = 0;
  const readLength = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = bytes[at++];
      value += (byte & 127) << shift;
      if (byte < 128) return value;
    }
  };
  /** @type {string[]} */
  const names = [];
  while (at < bytes.length) {
    const length = readLength();
    if (length === 0) continue;
    if (readLength() !== 0) throw new Error('compressed names: build with -enable-name-compression=false');
    names.push(...bytes.toString('latin1', at, at + length).split('\x01'));
    at += length;
  }
  return names;
}

process.on('exit', () => {
  for (const exports of alive) read(exports);
  if (sums.size === 0) return;
  mkdirSync(counters, { recursive: true });
  writeFileSync(new URL(`${process.pid}-${threadId}.json`, counters), JSON.stringify([...sums]));
});
