// What the page says of numbers by index, of proofs and of curves.
import {counted, short} from './names.js';

const of_index = ([n, i]) => `${n} ${i ? `of index ${i}` : 'stable'}`;

// 2 stable, 6 of index 1
export const by_index_in_words = by_index => by_index.map((n, i) => [n, i]).filter(([n]) => n).map(of_index).join(', ');

// born: 2 stable and 2 of index 1; nothing where nothing changed
export function change_in_words(before, now) {
    if (!before || before.length !== now.length) return '';
    const list = sign => now.map((n, i) => [(n - before[i]) * sign, i]).filter(([n]) => n > 0).map(of_index).join(' and ');
    const born = list(1), gone = list(-1);
    return [born && `born: ${born}`, gone && `gone: ${gone}`].filter(Boolean).join('; ');
}

// What is proved: {mark, text}; the mark says it in short, or is empty.
export function proof_in_words({proof, real, clean, alarms}) {
    const these = real === 1 ? 'this one is' : `these ${real} are`, capital = text => `${text[0]?.toUpperCase() ?? ''}${text.slice(1)}`;
    if (proof.complete) {
        const indices = proof.index === proof.real ? ', each with its index' : '';
        return {mark: `✓ Proved: ${these} all.`, text: `${capital(proof.reason)}; ${proof.real} of them real${indices}.`};
    }
    const there = proof.undecided === 0 && proof.real === real;
    return {mark: there ? `✓ Proved: ${these} there.` : '', text: `That there are no others is not proved: ${proof.reason}.${clean ? '' : ` ${alarms}`}`};
}

// 2 fold curves, 4 pitchfork curves, 2 cusps, 7 regions; none is missing
export function locus_in_words({curves, cusps, regions, evidence}, milliseconds) {
    const folds = curves.filter(c => c.kind === 'fold').length;
    const parts = [[folds, 'fold curve'], [curves.length - folds, 'pitchfork curve'], [cusps.length, 'cusp'], [regions.length, 'region']];
    return `${parts.filter(([n]) => n).map(([n, one]) => counted(n, one)).join(', ')}; ${evidence.complete ? 'none is missing' : 'some may be missing'} (${short(milliseconds / 1000, 2)} s).`;
}

// 4 pitchforks, 6 folds along the line.
export function line_in_words({events, failed_paths, complete = true}) {
    const kinds = {};
    for (const {kind} of events) kinds[kind] = (kinds[kind] ?? 0) + 1;
    const found = Object.entries(kinds).map(([kind, n]) => counted(n, kind)).join(', ');
    return `${found ? `${found} along the line` : 'No equilibrium is born or dies along the line'}${failed_paths ? `; ${counted(failed_paths, 'path')} failed` : complete ? '' : '; some may be missing'}.`;
}
