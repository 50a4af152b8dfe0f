/** The solver in a worker, as the page asks it: one task at a time, the newest of a kind in place of an older one that still waits. */

/** @typedef {{ task: string, request: unknown, report: (progress: any) => void, resolve: (value: any) => void, reject: (reason: unknown) => void }} Job */

export class Solver {
  /** @type {Worker | null} */ #worker = null;
  /** @type {Job[]} */ #waiting = [];
  /** @type {Job | null} */ #running = null;
  #id = 0;
  #onBusy;

  /** @param {(busy: boolean) => void} [onBusy] */
  constructor(onBusy = () => {}) {
    this.#onBusy = onBusy;
  }

  /**
   * @param {string} task
   * @param {unknown} request
   * @param {(progress: any) => void} [report]
   * @returns {Promise<any>} null if a newer one of the same task took its place, or it was cancelled
   */
  ask(task, request, report = () => {}) {
    this.#drop((job) => job.task === task);
    return new Promise((resolve, reject) => {
      this.#waiting.push({ task, request, report, resolve, reject });
      this.#next();
    });
  }

  /** Gives up everything. A task that runs is ended with its worker; the next one gets a new worker. */
  cancel() {
    this.#drop(() => true);
    if (!this.#running) return;
    this.#worker?.terminate();
    this.#worker = null;
    this.#end((job) => job.resolve(null));
  }

  /** @param {(job: Job) => boolean} test */
  #drop(test) {
    for (const job of this.#waiting.filter(test)) job.resolve(null);
    this.#waiting = this.#waiting.filter((job) => !test(job));
  }

  #next() {
    if (this.#running) return;
    const job = this.#waiting.shift();
    this.#onBusy(job !== undefined);
    if (!job) return;
    this.#running = job;
    this.#worker ??= this.#start();
    this.#worker.postMessage({ id: ++this.#id, task: job.task, request: job.request });
  }

  #start() {
    const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }) => this.#receive(data));
    worker.addEventListener('error', () => this.#end((job) => job.reject(new Error('The worker could not be started.'))));
    return worker;
  }

  /** @param {{ id: number, progress?: unknown, result?: unknown, error?: object }} data */
  #receive({ id, progress, result, error }) {
    if (id !== this.#id) return;
    if (progress !== undefined) this.#running?.report(progress);
    else if (error) this.#end((job) => job.reject(Object.assign(new Error(), error)));
    else this.#end((job) => job.resolve(result));
  }

  /** @param {(job: Job) => void} settle */
  #end(settle) {
    const job = this.#running;
    this.#running = null;
    if (job) settle(job);
    this.#next();
  }
}
