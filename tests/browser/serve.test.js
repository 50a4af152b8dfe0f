// The server of `make demo`: right types, a strict policy, and no way out of the project's served folders.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { get, request } from 'node:http';
import { after, before, test } from 'node:test';
import { serve } from '../../demo/serve.js';

/** @type {Awaited<ReturnType<typeof serve>>} */ let server;
before(async () => {
  server = await serve();
});
after(() => server.close());

/**
 * Asks for a path exactly as written: fetch would tidy its dots away.
 * @param {string} path @param {string} [method]
 * @returns {Promise<{ status: number | undefined, headers: import('node:http').IncomingHttpHeaders, body: string }>}
 */
function ask(path, method = 'GET') {
  const { hostname, port } = new URL(server.address);
  return new Promise((resolve, reject) => {
    const call = (method === 'GET' ? get : request)({ hostname, port, path, method }, async (response) => {
      let body = '';
      for await (const part of response.setEncoding('utf8')) body += part;
      resolve({ status: response.statusCode, headers: response.headers, body });
    });
    call.on('error', reject).end();
  });
}

test('it listens on the loopback interface only', () => {
  assert.match(server.address, /^http:\/\/127\.0\.0\.1:\d+\/demo\/$/);
});

for (const [path, type] of [
  ['/demo/', 'text/html; charset=utf-8'],
  ['/demo/main.js', 'text/javascript; charset=utf-8'],
  ['/demo/style.css?again', 'text/css; charset=utf-8'],
  ['/demo/icon.svg', 'image/svg+xml'],
  ['/dist/surfpath.wasm', 'application/wasm'],
  ['/node_modules/three/build/three.module.js', 'text/javascript; charset=utf-8'],
])
  test(`${path} is ${type}`, async () => {
    const { status, headers } = await ask(path);
    assert.equal(status, 200);
    assert.equal(headers['content-type'], type);
    assert.equal(headers['x-content-type-options'], 'nosniff');
  });

for (const path of [
  '/../package.json',
  '/demo/../package.json',
  '/demo/..%2fpackage.json',
  '/demo/%2e%2e/%2e%2e/%2e%2e/etc/passwd',
  '/demo/..\\package.json',
  '/package.json',
  '/tests/browser/serve.test.js',
  '/node_modules/playwright-core/package.json',
  '/demo/missing.js',
  '/demo/%',
  '/demo/%00.js',
  '//demo/main.js',
  '/dist',
])
  test(`${path} is refused`, async () => {
    const { status, body } = await ask(path);
    assert.equal(status, 404);
    assert.equal(body, 'There is no such file.\n');
  });

test('the root leads to the page', async () => {
  for (const path of ['/', '/demo']) {
    const { status, headers } = await ask(path);
    assert.deepEqual([status, headers.location], [302, '/demo/']);
  }
});

test('it only reads', async () => {
  assert.equal((await ask('/demo/', 'POST')).status, 405);
  const { status, body } = await ask('/demo/', 'HEAD');
  assert.deepEqual([status, body], [200, '']);
});

test('the policy names nothing inline but the import map, by its hash', async () => {
  const { headers, body } = await ask('/demo/');
  const policy = String(headers['content-security-policy']);
  const map = /<script type="importmap">([\s\S]*?)<\/script>/.exec(body)?.[1] ?? '';
  assert.ok(map.includes('surfpath'));
  assert.ok(policy.includes(`'sha256-${createHash('sha256').update(map).digest('base64')}'`));
  assert.match(policy, /^default-src 'none'; script-src 'self' 'wasm-unsafe-eval' 'sha256-/);
  assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|data:|blob:|\*/);
});
