// What colours and marks mean, and how numbers are written: one place for the whole page. Colours
// are CSS variables, so that they follow the light or dark theme.

/// The name of a CSS variable by the first word of what it colours.
function variableOf(kind, name) {
    return `--${kind}-${name.split('_')[0]}`;
}

/// Both themes' colours of families and classes, as CSS variables.
function themeRule(theme) {
    const variables = [['family', VOCABULARY.families], ['class', VOCABULARY.classes]].flatMap(([kind, terms]) =>
        terms.map(term => `${variableOf(kind, term.name)}: ${term[theme]};`));
    return `.${theme}-theme { ${variables.join(' ')} }`;
}
document.head.append(element('style', {}, themeRule('light'), themeRule('dark')));

const FAMILIES = Object.fromEntries(VOCABULARY.families.map(family =>
    [family.name, {title: family.title, colour: `var(${variableOf('family', family.name)})`}]));

/// Markers as paths of about 10 px; a method has its own within its family.
const MARKERS = Object.fromEntries(VOCABULARY.markers.map(marker => [marker.name, marker.path]));

function familyOf(info) {
    return FAMILIES[info.family] || FAMILIES.other;
}

function colourOf(info) {
    return info.isBaseline ? 'var(--soft)' : familyOf(info).colour;
}

function markerOf(info) {
    return MARKERS[info.marker] || MARKERS.circle;
}

const CLASS_COLOURS = Object.fromEntries([...CLASSES, ...CLASS_PARTS.keys()].map(name =>
    [name, `var(${variableOf('class', name)})`]));

/// "#rrggbb" as [red, green, blue].
function rgbOf(hex) {
    return [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16));
}

/// Why a pixel is wrong, in the order of the pixel codes of images. `rgb` is for images, which always
/// stand on white: the colours of figures for papers, chosen so that all of them keep apart for every
/// kind of colour vision.
/// A miss of a method that declares no code has no cause that is known: it looks like any miss.
const isKnownCause = ({name}) => name !== 'undeclared';
const CAUSES = VOCABULARY.causes.map(cause => ({...cause, rgb: rgbOf(isKnownCause(cause) ? cause.figure : VOCABULARY.marks.missing)}));

/// The two colours of errors where causes are not asked for, and those of the labels of a truth.
const FALSE_RGB = rgbOf(VOCABULARY.marks.false);
const MISSING_RGB = rgbOf(VOCABULARY.marks.missing);
const IGNORED_RGB = rgbOf(VOCABULARY.marks.ignored);
const LABEL_RGB = [rgbOf(VOCABULARY.marks.paper), ...VOCABULARY.classes.map(each => rgbOf(each.figure)), IGNORED_RGB, IGNORED_RGB];

function rgbText(rgb) {
    return `rgb(${rgb.join(', ')})`;
}

// ---- Numbers ------------------------------------------------------------------------------

const NOTHING = '–';

function isNumber(value) {
    return typeof value === 'number' && Number.isFinite(value);
}

/// A number with so many decimals, as the program rounds it: what lies right between two goes to the
/// even one, where toFixed takes the larger.
function fixed(value, digits) {
    const scaled = value * 10 ** digits;
    const isBetween = Number.isInteger(value * 2 ** (digits + 1)) && Math.abs(scaled % 1) === 0.5;
    return (isBetween ? 2 * Math.round(scaled / 2) / 10 ** digits : value).toFixed(digits);
}

/// A share, 0..1, with three digits.
function formatShare(value, digits = 3) {
    return isNumber(value) ? fixed(value, digits) : NOTHING;
}

function formatSigned(value, digits = 3) {
    if (!isNumber(value)) return NOTHING;
    const text = Math.abs(value).toFixed(digits);
    if (Number(text) === 0) return text;
    return (value < 0 ? '−' : '+') + text;
}

/// "0.912 to 0.934"; nothing without an interval.
function formatRange(range, digits = 3) {
    return range ? `${fixed(range.low, digits)} to ${fixed(range.high, digits)}` : NOTHING;
}

function formatSignedRange(range, digits = 3) {
    return range
        ? `${formatSigned(range.low, digits)} to ${formatSigned(range.high, digits)}` : NOTHING;
}

/// Three digits that count.
function formatNumber(value) {
    if (!isNumber(value)) return NOTHING;
    const size = Math.abs(value);
    if (Number.isInteger(value) && size < 100000) return String(value);
    if (size >= 100000) return d3.format('.3s')(value).replace('G', ' G').replace('M', ' M').replace('k', ' k');
    if (size >= 100) return value.toFixed(0);
    if (size >= 10) return value.toFixed(1);
    if (size >= 1) return value.toFixed(2);
    if (size >= 0.001) return String(Number(value.toPrecision(3)));
    return value.toExponential(1);
}

/// Milliseconds with three digits that count, as the program writes them.
function formatMs(ms) {
    if (!isNumber(ms)) return NOTHING;
    // What rounds to 10 or 100 is shown as such: 9.996 is "10.0", not "10.00".
    return ms.toFixed(ms < 0.0995 ? 3 : ms < 9.995 ? 2 : ms < 99.95 ? 1 : 0);
}

function formatPercent(share, digits = 1) {
    return isNumber(share) ? `${(100 * share).toFixed(digits)} %` : NOTHING;
}

function count(number, noun) {
    return `${number} ${noun}${number === 1 ? '' : 's'}`;
}
