// The page: its panels, and what they do when they are used. What is shown is in shown.js, what the panels share in parts.js.
import {Engine} from './engine.js';
import {Plane} from './plane.js';
import {Shapes} from './shapes.js';
import {Diagram} from './diagram.js';
import {Motion} from './motion.js';
import {Tabs} from './tabs.js';
import {ControlsPanel} from './controls_panel.js';
import {AxesPanel} from './axes_panel.js';
import {OwnPanel} from './own_panel.js';
import {shown, kind, put_address} from './shown.js';
import {$, panels, slow, times} from './parts.js';
import {move_to, set_parameter, view, frame} from './moves.js';
import {open, open_address, choose_axes, choose_line} from './opening.js';
import {open_structures} from './structures_tab.js';
import {tell_chosen} from './at_point.js';
import {fill_table} from './at_rest.js';
import {trace_plane} from './plane_curves.js';
import {saved, listen_to_saving} from './saving.js';

Object.assign(panels, {
    plane: new Plane($('#plane'), {moved: move_to, viewed: view}),
    shapes: new Shapes($('#shapes'), {chosen: tell_chosen}),
    line: new Diagram($('#diagram'), {moved: (value, time) => set_parameter(shown.state.line, value, time)}),
    motion: new Motion($('#motion-panel'), new Engine()),
    tabs: new Tabs($('nav'), {opened: id => (id === 'structures' ? open_structures() : open({view: id}))}),
    controls: new ControlsPanel({opened: open, parameter_set: set_parameter, line_chosen: choose_line}),
    axes: new AxesPanel($('#axes'), {viewed: view, chosen: choose_axes}),
    own: new OwnPanel($('#own'), {opened: open}),
});

$('#show').addEventListener('change', () => {
    shown.state.show = Number($('#show').value);
    frame();
    put_address();
});
$('#zoom-in').addEventListener('click', () => panels.plane.zoom(0.5));
$('#zoom-out').addEventListener('click', () => panels.plane.zoom(2));
$('#zoom-home').addEventListener('click', () => {
    const {state} = shown, start = kind().start(state);
    view(start.x ?? state.home.x, start.y ?? state.home.y);
});
$('#locus-stop').addEventListener('click', () => {
    slow.stop();
    $('#locus-stop').hidden = true;
    $('#locus-status').textContent = 'Stopped.';
    $('#locus-trace').hidden = false;
});
$('#locus-trace').addEventListener('click', () => trace_plane('curves'));
$('#table').addEventListener('toggle', fill_table);
listen_to_saving();
addEventListener('hashchange', open_address);
open_address();

// For tests: what is shown, and how long it took.
window.explorer = {
    get state() { return shown.state; }, get model() { return shown.model; }, get solution() { return shown.solution; }, get locus() { return shown.locus; },
    get diagram() { return shown.diagram; }, get proof() { return shown.proof; }, get equilibria() { return shown.equilibria; }, times, open, move_to, saved,
};
