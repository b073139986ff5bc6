// The engine in a worker. In: {module}, once; then {id, request}, or {id, sweep: {request, points}}, which solves at each point in
// turn. Out: {ready}; {id, response}, {id, error}, or {id, rows} for a part of a sweep. A call that traps costs the instance, not the module.
import {imports_of} from './wasi.js';

let module, instance;

function start() {
    let memory;
    instance = new WebAssembly.Instance(module, imports_of(module, () => memory));
    memory = instance.exports.memory;
    instance.exports._initialize?.();
}

function text_at(pointer) {
    const bytes = new Uint8Array(instance.exports.memory.buffer);
    let end = pointer;
    while (bytes[end]) ++end;
    return new TextDecoder().decode(bytes.subarray(pointer, end));
}

function run(request) {
    if (!instance) start();
    const {engine_alloc, engine_free, engine_run, engine_error, memory} = instance.exports;
    let answer;
    try {
        const bytes = new TextEncoder().encode(JSON.stringify(request));
        const pointer = engine_alloc(bytes.length + 1);
        new Uint8Array(memory.buffer).set(bytes, pointer);
        const response = engine_run(pointer, bytes.length);
        engine_free(pointer);
        answer = text_at(response);
    } catch (trap) {
        let reason = '';
        try {
            reason = text_at(engine_error());
        } catch { /* the instance is past that */ }
        instance = undefined;
        throw new Error(reason || `the engine stopped: ${trap.message}`);
    }
    const response = JSON.parse(answer);
    if (response.error !== undefined) throw new Error(response.error);
    return response;
}

// What the page draws with of a solution: not its complex roots.
function lean({roots, multiplicities, winding_numbers, families, failures, ...rest}) {
    return rest;
}

function sweep(id, {request, points}) {
    let rows = [], posted = performance.now();
    const post = last => {
        postMessage({id, rows, last});
        rows = [];
        posted = performance.now();
    };
    for (const {set, key} of points) {
        let row = {key, by_index: null};
        try {
            const found = run({...request, set: {...request.set, ...set}});
            row = {key, by_index: found.by_index, count: found.real, clean: found.clean};
            if (request.keep) row.equilibria = found.equilibria.map(e => ({index: e.index, q: [...(e.angles ?? []), ...(e.coordinates ?? [])]}));
        } catch { /* no answer there: the place stays empty */ }
        rows.push(row);
        if (performance.now() - posted > 60) post(false);
    }
    post(true);
}

onmessage = ({data}) => {
    if (data.module) {
        module = data.module;
        try {
            start();
            postMessage({ready: true});
        } catch (error) {
            postMessage({failed: error.message});
        }
        return;
    }
    const {id, request, sweep: points, full} = data;
    try {
        if (points) return sweep(id, points);
        const started = performance.now(), response = run(request);
        postMessage({id, response: full ? response : lean(response), milliseconds: performance.now() - started});
    } catch (error) {
        postMessage({id, error: error.message});
    }
};
