// The page's side of the engine: it is unpacked and compiled once, and each worker is given the module. A worker does one thing at a
// time; what is asked of it meanwhile waits, and only the newest question waits.
import worker_source from 'inline:worker';
import {Host, lean} from './host.js';

let compiled;
function module() {
    return (compiled ??= (async () => {
        const packed = document.getElementById('engine').textContent.trim();
        const bytes = Uint8Array.from(atob(packed), c => c.charCodeAt(0));
        const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
        const made = await WebAssembly.compile(await new Response(stream).arrayBuffer());
        setTimeout(() => {
            here = new Host(made);
            here.start();
        }, 1500);  // after the first picture
        return made;
    })());
}

const worker_url = URL.createObjectURL(new Blob([worker_source], {type: 'text/javascript'}));
let next_id = 1, here = null;

export class Overtaken extends Error {}

export class Engine {
    #worker = null;
    #busy = null;     // {id, resolve, reject, rows}
    #waiting = null;  // {message, resolve, reject, rows}

    async #start() {
        const code = await module();
        if (this.#worker) return;
        this.#worker = new Worker(worker_url);
        this.#worker.onmessage = ({data}) => this.#hear(data);
        this.#worker.onerror = event => this.#hear({id: this.#busy?.id, error: event.message ?? 'the worker stopped'});
        this.#worker.postMessage({module: code});
    }

    #hear(data) {
        if (data.failed) return this.#settle('reject', new Error(data.failed));
        if (!this.#busy || data.id !== this.#busy.id) return;
        if (data.rows) {
            this.#busy.rows?.(data.rows);
            if (data.last) this.#settle('resolve', {});
        } else if (data.error !== undefined) {
            this.#settle('reject', new Error(data.error));
        } else {
            this.#settle('resolve', data);
        }
    }

    #settle(how, value) {
        const done = this.#busy;
        this.#busy = null;
        done?.[how](value);
        this.#next();
    }

    #next() {
        if (this.#busy || !this.#waiting) return;
        this.#busy = {id: next_id++, ...this.#waiting};
        this.#waiting = null;
        const post = () => this.#busy && this.#worker.postMessage({id: this.#busy.id, ...this.#busy.message});
        if (this.#worker) post();  // at once: the worker begins while the last answer is drawn
        else this.#start().then(post, error => this.#settle('reject', error));
    }

    #ask(message, rows) {
        return new Promise((resolve, reject) => {
            this.#waiting?.reject(new Overtaken());
            this.#waiting = {message, resolve, reject, rows};
            this.#next();
        });
    }

    get busy() {
        return this.#busy !== null;
    }
    // The answer to a request, with its milliseconds: {response, milliseconds}.
    run(request, {full = false} = {}) {
        return this.#ask({request, full});
    }
    // Solves at many points; rows is called with each part of the answer.
    sweep(request, points, rows, keep = false) {
        return this.#ask({sweep: {request, points, keep}}, rows);
    }
    // The same at once, on the page itself, if that has lately taken no more than a few milliseconds: a worker's answer would have to
    // wait for its turn. Null if it may take longer.
    run_here(request) {
        if (!here || !(this.quick < 3.5)) return null;
        const started = performance.now(), response = lean(here.run(request)), milliseconds = performance.now() - started;
        this.quick = milliseconds > 12 ? Infinity : Math.max(milliseconds, 0.7 * this.quick);
        return {response, milliseconds};
    }
    // Drops what is under way and what waits.
    stop() {
        this.#worker?.terminate();
        this.#worker = null;
        const dropped = [this.#busy, this.#waiting];
        this.#busy = this.#waiting = null;
        for (const job of dropped) job?.reject(new Overtaken());
    }
}
