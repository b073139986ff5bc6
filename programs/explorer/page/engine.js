// The page's side of the engine: it is unpacked and compiled once, and each worker is given the module. A worker does one thing at a
// time; what is asked of it meanwhile waits, and only the newest question waits.
import worker_source from 'inline:worker';

let compiled;
function module() {
    return (compiled ??= (async () => {
        const packed = document.getElementById('engine').textContent.trim();
        const bytes = Uint8Array.from(atob(packed), c => c.charCodeAt(0));
        const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
        return WebAssembly.compile(await new Response(stream).arrayBuffer());
    })());
}

const worker_url = URL.createObjectURL(new Blob([worker_source], {type: 'text/javascript'}));
let next_id = 1;

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
        this.#start().then(
            () => this.#busy && this.#worker.postMessage({id: this.#busy.id, ...this.#busy.message}),
            error => this.#settle('reject', error));
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
    sweep(request, points, rows) {
        return this.#ask({sweep: {request, points}}, rows);
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
