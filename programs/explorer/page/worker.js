// The engine in a worker. In: {module}, once; then {id, request}, or {id, sweep: {request, points, keep}}, which solves at each point
// in turn. Out: {id, response}, {id, error}, or {id, rows, last} for a part of a sweep; {failed} if the engine does not start.
import {Host, lean} from './host.js';

let host;

function sweep(id, {request, points, keep}) {
    let rows = [], posted = performance.now();
    const post = last => {
        postMessage({id, rows, last});
        rows = [];
        posted = performance.now();
    };
    for (const {set, key} of points) {
        let row = {key, by_index: null};
        try {
            const found = host.run({...request, set: {...request.set, ...set}});
            row = {key, by_index: found.by_index, count: found.real, clean: found.clean};
            if (keep) row.equilibria = found.equilibria.map(e => ({index: e.index, q: [...(e.angles ?? []), ...(e.coordinates ?? [])]}));
        } catch { /* no answer there: the place stays empty */ }
        rows.push(row);
        if (performance.now() - posted > 60) post(false);
    }
    post(true);
}

onmessage = ({data}) => {
    const {module, id, request, sweep: points, full} = data;
    try {
        if (module) {
            host = new Host(module);
            host.start();
        } else if (points) {
            sweep(id, points);
        } else {
            const started = performance.now(), response = host.run(request);
            postMessage({id, response: full ? response : lean(response), milliseconds: performance.now() - started});
        }
    } catch (error) {
        postMessage(module ? {failed: error.message} : {id, error: error.message});
    }
};
