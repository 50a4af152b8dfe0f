/**
 * The solver in a worker, as the page asks it: one task at a time, the newest of a kind in place of an older one that still waits, or that runs and listens.
 * A task that takes long is said to, with how far it is where it knows; it can be cancelled, and is given up where it is about a surface that is no longer
 * asked for, or where it is asked anew about something else.
 */

/**
 * @typedef {object} Job
 * @property {string} task @property {any} request
 * @property {(progress: any) => void} report @property {(value: any) => void} resolve @property {(reason: unknown) => void} reject
 */
/** @typedef {{ task: string, isSlow: boolean, share: number | null }} Work what is being done; share: in [0, 1], null: nobody knows */

/** Milliseconds from which a task is long: the page says so, and another surface does not wait for it; and from which nothing else does that it does not answer. */
const [PATIENCE, LONGEST] = [400, 1500];

/** Tasks that answer what a task asks. @type {Record<string, string[]>} */
const ANSWERS = { solve: ['solve', 'open'] };

/** What a task that was cancelled is rejected with. */
class Cancelled extends Error {
  constructor() {
    super('Cancelled. Change anything to compute it anew.');
  }
}

export class Solver {
  /** @type {Worker | null} */ #worker = null;
  /** @type {Job[]} */ #waiting = [];
  /** @type {Job | null} */ #running = null;
  /** @type {Work | null} */ #work = null;
  #id = 0;
  #timer = 0;
  /** Of these milliseconds, those that what runs has taken. */ #taken = 0;
  #onWork;

  /** @param {(work: Work | null) => void} onWork null: it is idle, and all that waited for an answer has had its turn */
  constructor(onWork) {
    this.#onWork = onWork;
  }

  /**
   * @param {string} task
   * @param {{ definition: object, [name: string]: any }} request
   * @param {(progress: any) => void} [report] a number `share` in the progress says how far it is, a name `task` what is done from now on
   * @returns {Promise<any>} null if a newer one took its place; rejects with `Cancelled`
   */
  ask(task, request, report = () => {}) {
    this.#drop((job) => job.task === task);
    if (this.#running?.task === task) this.#worker?.postMessage({ stop: this.#id });
    return new Promise((resolve, reject) => {
      this.#waiting.push({ task, request, report, resolve, reject });
      this.#giveWay();
      this.#next();
    });
  }

  /** Starts the worker before there is anything to do: it takes its time. */
  warm() {
    this.#worker ??= this.#start();
  }

  /** Gives up everything: a task that runs is ended with its worker, and the next one gets a new worker. */
  cancel() {
    for (const job of this.#waiting) job.reject(new Cancelled());
    this.#waiting = [];
    if (this.#running) this.#stop((job) => job.reject(new Cancelled()));
    this.#tell(null);
  }

  /** Ends what runs where it has been long about what is not asked any more: a surface that is not that of what waits, or an older question about it. */
  #giveWay() {
    const running = this.#running;
    if (!running || this.#taken < PATIENCE) return;
    const isOther = (/** @type {Job} */ { request }) => JSON.stringify(running.request.definition) !== JSON.stringify(request.definition);
    const isAnew = (/** @type {Job} */ { task }) => this.#taken === LONGEST && (ANSWERS[task] ?? [task]).includes(running.task);
    if (this.#waiting.some((job) => isAnew(job) || isOther(job))) this.#stop((job) => job.resolve(null));
  }

  /** Notes what time what runs has taken. @param {number} taken */
  #wait(taken) {
    this.#taken = taken;
    if (taken === PATIENCE) {
      this.#tell({ isSlow: true });
      this.#timer = window.setTimeout(() => this.#wait(LONGEST), LONGEST - PATIENCE);
    }
    this.#giveWay();
  }

  /** @param {(job: Job) => boolean} test */
  #drop(test) {
    for (const job of this.#waiting.filter(test)) job.resolve(null);
    this.#waiting = this.#waiting.filter((job) => !test(job));
  }

  #next() {
    if (this.#running) return;
    const job = this.#waiting.shift();
    // Who has just been answered asks on at once, as a rule: idle is who is still idle then.
    if (!job) return setTimeout(() => this.#running || this.#tell(null));
    this.#running = job;
    this.#worker ??= this.#start();
    this.#worker.postMessage({ id: ++this.#id, task: job.task, request: job.request });
    this.#taken = 0;
    this.#timer = window.setTimeout(() => this.#wait(PATIENCE), PATIENCE);
    this.#work = null;
    return this.#tell({ task: job.task, isSlow: false, share: null });
  }

  /** @param {Partial<Work> | null} change */
  #tell(change) {
    this.#work = change && { task: '', isSlow: false, share: null, ...this.#work, ...change };
    this.#onWork(this.#work);
  }

  #start() {
    // Beside the bundle that this file becomes a part of.
    const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }) => this.#receive(data));
    worker.addEventListener('error', () => {
      if (worker === this.#worker) this.#stop((job) => job.reject(new Error('The worker could not be started.')));
    });
    return worker;
  }

  /** @param {{ id: number, progress?: any, result?: unknown, error?: object }} data */
  #receive({ id, progress, result, error }) {
    if (id !== this.#id || !this.#running) return;
    if (progress !== undefined) {
      this.#running.report(progress);
      if (Number.isFinite(progress.share)) this.#tell({ share: progress.share });
      if (progress.task) this.#tell({ task: progress.task });
    } else if (error) this.#end((job) => job.reject(Object.assign(new Error(), error)));
    else this.#end((job) => job.resolve(result));
  }

  /** Ends the worker with what it does. @param {(job: Job) => void} settle */
  #stop(settle) {
    this.#worker?.terminate();
    this.#worker = null;
    this.#end(settle);
  }

  /** @param {(job: Job) => void} settle */
  #end(settle) {
    clearTimeout(this.#timer);
    const job = this.#running;
    this.#running = null;
    if (job) settle(job);
    this.#next();
  }
}
