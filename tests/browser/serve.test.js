// The server of `make demo`: right types, a strict policy, and no way out of the project's served folders.
import assert from 'node:assert/strict';
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
  assert.match(server.address, /^http:\/\/127\.0\.0\.1:\d+\/surfpath\/$/);
});

for (const [path, type] of [
  ['/surfpath/', 'text/html; charset=utf-8'],
  ['/surfpath/main.js', 'text/javascript; charset=utf-8'],
  ['/surfpath/style.css?again', 'text/css; charset=utf-8'],
  ['/surfpath/icon.svg', 'image/svg+xml'],
  ['/surfpath/thumbnails/saddle.webp', 'image/webp'],
])
  test(`${path} is ${type}`, async () => {
    const { status, headers } = await ask(path);
    assert.equal(status, 200);
    assert.equal(headers['content-type'], type);
    assert.equal(headers['x-content-type-options'], 'nosniff');
  });

for (const path of [
  '/../package.json',
  '/surfpath/../package.json',
  '/surfpath/..%2f..%2fpackage.json',
  '/surfpath/%2e%2e/%2e%2e/%2e%2e/etc/passwd',
  '/surfpath/..\\package.json',
  '/package.json',
  '/tests/browser/serve.test.js',
  '/main.js',
  '/surfpath/missing.js',
  '/surfpath/%',
  '/surfpath/%00.js',
  '//surfpath/main.js',
  '/surfpath/thumbnails',
])
  test(`${path} is refused`, async () => {
    const { status, body } = await ask(path);
    assert.equal(status, 404);
    assert.equal(body, 'There is no such file.\n');
  });

test('the root leads to the page', async () => {
  for (const path of ['/', '/surfpath']) {
    const { status, headers } = await ask(path);
    assert.deepEqual([status, headers.location], [302, '/surfpath/']);
  }
});

test('it only reads', async () => {
  assert.equal((await ask('/surfpath/', 'POST')).status, 405);
  const { status, body } = await ask('/surfpath/', 'HEAD');
  assert.deepEqual([status, body], [200, '']);
});

test('the policy is the strictest that the page runs under, and the page has nothing inline', async () => {
  const { headers, body } = await ask('/surfpath/');
  assert.equal(
    headers['content-security-policy'],
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; worker-src 'self'",
  );
  assert.doesNotMatch(body, /<script(?![^>]* src=)|<style| style=| on\w+=|(?:src|href)="(?:\/|https?:)/);
});
