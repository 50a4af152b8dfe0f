/** How long the scripts of a page keep its own thread: the tasks of Chromium's trace, in processor time, so that neither a busy machine nor the drawing counts. */

/** Events of the trace in which a script runs. */
const SCRIPTS = new Set([
  'EvaluateScript',
  'v8.evaluateModule',
  'FunctionCall',
  'TimerFire',
  'FireAnimationFrame',
  'EventDispatch',
  'RunMicrotasks',
]);

/** @typedef {{ name: string, milliseconds: number, lasted: number, at: string }} Task milliseconds: of the processor; lasted: by the clock; at: the function and place, where known */

/**
 * Does something in a page and watches its scripts.
 * @param {import('playwright-core').Page} page @param {() => Promise<unknown>} act
 * @returns {Promise<Task[]>} the tasks of the page's thread in which scripts ran, the longest first
 */
export async function watchTasks(page, act) {
  const session = await page.context().newCDPSession(page);
  /** @type {any[]} */ const events = [];
  session.on('Tracing.dataCollected', ({ value }) => events.push(...value));
  const complete = new Promise((resolve) => session.once('Tracing.tracingComplete', resolve));
  await session.send('Tracing.start', {
    categories: 'devtools.timeline,v8.execute,disabled-by-default-v8.compile,__metadata',
    transferMode: 'ReportEvents',
  });
  await act();
  await session.send('Tracing.end');
  await complete;
  await session.detach();
  return tasksOf(events);
}

/** @param {any[]} events @returns {Task[]} */
function tasksOf(events) {
  const mains = new Set(events.filter(({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain').map(threadOf));
  const scripts = events
    .filter((event) => SCRIPTS.has(event.name) && event.ph === 'X' && mains.has(threadOf(event)))
    .sort((a, b) => a.ts - b.ts || b.dur - a.dur);
  /** @type {Task[]} */ const tasks = [];
  /** Until when the last task of each thread lasts. @type {Map<string, number>} */ const ends = new Map();
  for (const event of scripts) {
    if (event.ts < (ends.get(threadOf(event)) ?? 0)) continue;
    ends.set(threadOf(event), event.ts + event.dur);
    const { functionName = '', lineNumber = '', columnNumber = '', type = '', url = '' } = event.args?.data ?? {};
    const at = `${type}${functionName} ${String(url).split('/').at(-1)}:${lineNumber}:${columnNumber}`;
    tasks.push({ name: event.name, milliseconds: (event.tdur ?? event.dur) / 1000, lasted: event.dur / 1000, at });
  }
  return tasks.sort((a, b) => b.milliseconds - a.milliseconds);
}

/** @param {{ pid: number, tid: number }} event */
const threadOf = ({ pid, tid }) => `${pid} ${tid}`;
