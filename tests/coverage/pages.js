/**
 * Loaded before a browser test by `node --import`: its pages get the sources of web/ where they ask for the bundles of dist/, and when they are
 * closed, Chromium's counts of what was run go to build/coverage/v8/, as Node's own do. The tests notice nothing but the time.
 */
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const root = fileURLToPath(new URL('../..', import.meta.url));
const BUNDLE = /\/dist\/(index|gallery|three|element)\.js$/;
const IN_VIEW = ['three', 'element'];
let written = 0;

/** @param {import('playwright-core').Page} page */
async function keepCounts(page) {
  const scripts = await page.coverage.stopJSCoverage();
  const result = scripts.flatMap(({ url, functions }) => {
    const [, file] = /^http:\/\/127\.0\.0\.1:\d+\/(web\/.*)/.exec(url) ?? [];
    return file ? [{ url: new URL(`file://${root}${file}`).href, functions }] : [];
  });
  writeFileSync(`${root}build/coverage/v8/page-${process.pid}-${written++}.json`, JSON.stringify({ result }));
}

/** @param {import('playwright-core').BrowserContext} context */
async function count(context) {
  await context.route(BUNDLE, (route) => {
    const [, name] = /** @type {RegExpExecArray} */ (BUNDLE.exec(new URL(route.request().url()).pathname));
    const source = `/web/${IN_VIEW.includes(name) ? 'view/' : ''}${name}.js`;
    return route.fulfill({ contentType: 'text/javascript', body: `export * from '${source}';` });
  });
  const [newPage, closeAll] = [context.newPage.bind(context), context.close.bind(context)];
  context.newPage = async () => {
    const page = await newPage();
    await page.coverage.startJSCoverage({ resetOnNavigation: false });
    const close = page.close.bind(page);
    page.close = async () => {
      await keepCounts(page);
      await close();
    };
    return page;
  };
  context.close = async () => {
    for (const page of context.pages()) if (page.url() !== 'about:blank') await page.close();
    await closeAll();
  };
  return context;
}

const launch = chromium.launchPersistentContext.bind(chromium);
chromium.launchPersistentContext = async (folder, options) => count(await launch(folder, options));
