// The panel for saving: files of what is shown, and its address.
import {Engine} from './engine.js';
import {address} from './state.js';
import {svg_text, equilibria_csv, curves_csv, download} from './save.js';
import {shown, put_address} from './shown.js';
import {$, panels} from './parts.js';

// Name, type and text; null where there is nothing yet.
export async function saved(what) {
    const {state, model, solution, locus} = shown, name = model.name?.replace(/[^\w]+/g, '_') ?? 'model';
    if (what === 'plane-svg') return [`${name}_plane.svg`, 'image/svg+xml', svg_text($('#plane svg'), {behind: panels.plane.counted ? $('#plane canvas') : undefined})];
    if (what === 'diagram-svg') return [`${name}_diagram.svg`, 'image/svg+xml', svg_text($('#diagram svg'))];
    if (what === 'equilibria-csv') return [`${name}_equilibria.csv`, 'text/csv', equilibria_csv(solution?.equilibria ?? [])];
    if (what === 'curves-csv') return locus ? [`${name}_curves.csv`, 'text/csv', curves_csv(locus, state.x[0], state.y[0])] : null;
    const engine = new Engine(), {response} = await engine.run({command: 'solve', model, set: state.parameters, prove: true}, {full: true}).finally(() => setTimeout(() => engine.stop()));
    return [`${name}.json`, 'application/json', JSON.stringify({model: shown.model, address: address(shown.state), solution: response, locus: shown.locus, diagram: shown.diagram}, null, 2)];
}

export function listen_to_saving() {
    for (const made of document.querySelectorAll('[data-save]'))
        made.addEventListener('click', async () => {
            const file = await saved(made.dataset.save);
            if (file) download(...file);
            else $('#locus-status').textContent = 'No curves are traced yet.';
        });
    $('#share').addEventListener('click', async () => {
        put_address();
        try {
            await navigator.clipboard.writeText(location.href);
            $('#share').textContent = 'Copied';
        } catch {
            $('#share').textContent = 'The address bar has it';
        }
        setTimeout(() => ($('#share').textContent = 'Copy the address'), 2000);
    });
}
