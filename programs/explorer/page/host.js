// One instance of the engine, wherever it runs: a request in, its answer out. A call that traps costs the instance, not the module.
import {imports_of} from './wasi.js';

export class Host {
    constructor(module) {
        this.module = module;
    }

    start() {
        let memory;
        this.instance = new WebAssembly.Instance(this.module, imports_of(this.module, () => memory));
        memory = this.instance.exports.memory;
        this.instance.exports._initialize?.();
    }

    #text_at(pointer) {
        const bytes = new Uint8Array(this.instance.exports.memory.buffer), end = bytes.indexOf(0, pointer);
        return new TextDecoder().decode(bytes.subarray(pointer, end));
    }

    run(request) {
        if (!this.instance) this.start();
        const {engine_alloc, engine_free, engine_run, engine_error, memory} = this.instance.exports;
        let answer;
        try {
            const bytes = new TextEncoder().encode(JSON.stringify(request));
            const pointer = engine_alloc(bytes.length + 1);
            new Uint8Array(memory.buffer).set(bytes, pointer);
            const response = engine_run(pointer, bytes.length);
            engine_free(pointer);
            answer = this.#text_at(response);
        } catch (trap) {
            let reason = '';
            try {
                reason = this.#text_at(engine_error());
            } catch { /* the instance is past that */ }
            this.instance = undefined;
            throw new Error(reason || `the engine stopped: ${trap.message}`);
        }
        const response = JSON.parse(answer);
        if (response.error !== undefined) throw new Error(response.error);
        return response;
    }
}

// What the page draws with of a solution: not its complex roots.
export function lean({roots, multiplicities, winding_numbers, families, failures, ...rest}) {
    return rest;
}
