// What colours and marks mean, and how numbers are written: one place for the whole page. Colours
// are CSS variables, so that they follow the light or dark theme.

const FAMILIES = {
    packed: {title: 'packed codes', colour: 'var(--family-packed)'},
    full_buffers: {title: 'full buffers', colour: 'var(--family-full)'},
    ids: {title: 'ids', colour: 'var(--family-ids)'},
    edges_and_hulls: {title: 'edges and hulls', colour: 'var(--family-edges)'},
    other: {title: 'other', colour: 'var(--ink)'},
};

/// Markers as paths of about 10 px; a method has its own within its family.
const MARKERS = {
    circle: 'M5,0A5,5 0 1 1 -5,0A5,5 0 1 1 5,0Z',
    square: 'M-4.4,-4.4H4.4V4.4H-4.4Z',
    diamond: 'M0,-6L6,0L0,6L-6,0Z',
    up: 'M0,-5.6L5.4,4.2H-5.4Z',
    down: 'M0,5.6L5.4,-4.2H-5.4Z',
    plus: 'M-1.8,-5.4H1.8V-1.8H5.4V1.8H1.8V5.4H-1.8V1.8H-5.4V-1.8H-1.8Z',
    cross: 'M-5.1,-2.5L-2.5,-5.1L0,-2.5L2.5,-5.1L5.1,-2.5L2.5,0L5.1,2.5L2.5,5.1L0,2.5L-2.5,5.1L-5.1,2.5L-2.5,0Z',
    left: 'M-5.6,0L4.2,-5.4V5.4Z',
    right: 'M5.6,0L-4.2,-5.4V5.4Z',
};

function familyOf(info) {
    return FAMILIES[info.family] || FAMILIES.other;
}

function colourOf(info) {
    return info.isBaseline ? 'var(--soft)' : familyOf(info).colour;
}

function markerOf(info) {
    return MARKERS[info.marker] || MARKERS.circle;
}

const CLASS_COLOURS = {
    contour: 'var(--class-contour)',
    boundary: 'var(--class-boundary)',
    crease: 'var(--class-crease)',
    intersection: 'var(--class-intersection)',
    intersection_above_crease: 'var(--class-intersection)',
    intersection_below_crease: 'var(--class-intersection)',
    seam: 'var(--class-seam)',
};

/// Why a pixel is wrong, in the order of the pixel codes of images. `rgb` is for images, which always
/// stand on white: the colours of figures for papers (notebooks/paper/style.py), chosen there so that
/// all of them keep apart for every kind of colour vision.
const CAUSES = [
    {name: 'one_triangle', kind: 'false_positives', rgb: [128, 0, 255],
     text: 'false: all samples lie in one triangle'},
    {name: 'one_patch', kind: 'false_positives', rgb: [149, 120, 239],
     text: 'false: all samples lie on one smooth patch'},
    {name: 'crack', kind: 'false_positives', rgb: [57, 74, 191],
     text: 'false: a true line is near, but out of reach'},
    {name: 'frame', kind: 'false_positives', rgb: [18, 0, 143],
     text: 'false: the true line lies outside the frame'},
    {name: 'other', kind: 'false_positives', rgb: [166, 77, 255],
     text: 'false: several surfaces, no true line between them'},
    {name: 'cancelled', kind: 'false_negatives', rgb: [207, 62, 171],
     text: 'missing: channels changed, but their changes cancel in the sum'},
    {name: 'below_threshold', kind: 'false_negatives', rgb: [64, 30, 10],
     text: 'missing: no channel changed enough'},
    {name: 'sub_pixel', kind: 'false_negatives', rgb: [128, 0, 80],
     text: 'missing: thinner than the distance of samples'},
    {name: 'thinned', kind: 'false_negatives', rgb: [207, 31, 97],
     text: 'missing: drawn, but thinning moved it out of reach'},
    {name: 'unexplained', kind: 'false_negatives', rgb: [159, 139, 80],
     text: 'missing: the code should have shown it'},
    {name: 'undeclared', kind: 'false_negatives', rgb: [143, 72, 134],
     text: 'missing, cause unknown: only packed codes can be analysed'},
];

/// The two colours of errors where causes are not asked for.
const FALSE_RGB = [32, 0, 255];
const MISSING_RGB = [255, 38, 92];
const LABEL_RGB = [[255, 255, 255], [32, 36, 42], [92, 33, 112], [14, 96, 35], [191, 120, 0], [0, 155, 207],
                   [205, 209, 214], [205, 209, 214]];

function rgbText(rgb) {
    return `rgb(${rgb.join(', ')})`;
}

// ---- Numbers ------------------------------------------------------------------------------

const NOTHING = '–';

function isNumber(value) {
    return typeof value === 'number' && Number.isFinite(value);
}

/// A share, 0..1, with three digits.
function formatShare(value, digits = 3) {
    return isNumber(value) ? value.toFixed(digits) : NOTHING;
}

function formatSigned(value, digits = 3) {
    if (!isNumber(value)) return NOTHING;
    const text = Math.abs(value).toFixed(digits);
    if (Number(text) === 0) return text;
    return (value < 0 ? '−' : '+') + text;
}

/// "0.912 to 0.934"; nothing without an interval.
function formatRange(range, digits = 3) {
    return range ? `${range.low.toFixed(digits)} to ${range.high.toFixed(digits)}` : NOTHING;
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

const formatMs = formatNumber;

function formatPercent(share, digits = 1) {
    return isNumber(share) ? `${(100 * share).toFixed(digits)} %` : NOTHING;
}

function count(number, noun) {
    return `${number} ${noun}${number === 1 ? '' : 's'}`;
}
