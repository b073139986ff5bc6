// How names are written: alpha as α, l1 as ℓ₁.
const greek = {
    alpha: 'α', beta: 'β', gamma: 'γ', delta: 'δ', epsilon: 'ε', theta: 'θ', kappa: 'κ', lambda: 'λ', mu: 'μ', nu: 'ν', rho: 'ρ', sigma: 'σ',
    tau: 'τ', phi: 'φ', psi: 'ψ', omega: 'ω', Omega: 'Ω',
};
const below = digits => digits.replace(/\d/g, digit => '₀₁₂₃₄₅₆₇₈₉'[digit]);

export function written(name, labels = {}) {
    if (labels[name]) return labels[name];
    const [, word, digits] = /^(.*?)_?(\d*)$/.exec(name);
    return (greek[word] ?? word.replaceAll('_', ' ')) + below(digits);
}

// As few digits as the eye needs.
export function short(value, digits = 5) {
    if (!Number.isFinite(value)) return '–';
    if (Math.abs(value) < 1e-13) return '0';
    return String(Number(value.toPrecision(digits))).replace('-', '−');
}
export const counted = (n, one, many = one + 's') => `${n} ${n === 1 ? one : many}`;
