// All rows: every cell with every column, to filter, sort and save.

state.define('rows.text', '');
state.define('rows.study', 'all');
state.define('rows.columns', []);

/// The columns that are shown unless the reader chooses others.
const ROWS_USUAL = ['method', 'scene', 'view', 'split', 'width', 'height', 'f_2px', 'f_1px', 'precision_2px',
    'recall_2px', 'ap',
                    'mean_width_px', 'draw_ns', 'truth_px', 'false_negatives', 'false_positives', 'status'];
const ROWS_TEXT = ['study', 'method', 'scene', 'view', 'projection', 'split', 'params', 'status', 'skips_off', 'image_hash',
    'version', 'commit',
                   'compiler', 'flags', 'cpu', 'simd'];
const ROWS_MOST = 60;

addSection({
    id: 'rows',
    title: 'All rows',
    intro: 'A line per cell: one method with its settings on one view. “Everything as CSV” saves all columns of ' +
        'the lines that the filters leave. The run folder has more: curves.csv (99 thresholds), tolerances.csv, ' +
        'and sweep.csv (the settings of sweeps).',
    isThere: view => view.run.table('rows.csv').lineCount > 0,
    uses: ['rows.study', 'rows.columns', 'sort.rows'],
    draw(root, view) {
        const box = element('div', {});
        const number = element('span', {class: 'note'});
        const show = () => {
            const rows = rowsLeft(view);
            number.textContent = `${count(rows.length, 'row')}`;
            box.replaceChildren();
            makeTable(box, {name: 'rows', lines: rows, columns: rowsColumns(view.run), most: ROWS_MOST,
                lineClass: row => (
                view.run.methods.get(row.method).isBaseline ? 'baseline' : null)});
        };
        root.append(rowsTools(view, show, number), box);
        show();
    },
});

function rowsStudies(run) {
    return distinct(run.table('rows.csv').lines, row => row.study);
}

/// Rows that the page's filters, the study and the text leave. Every word must stand in the name of
/// something; words with "=" are looked up among the parameters.
function rowsLeft(view) {
    const words = state.get('rows.text').toLowerCase().split(/\s+/).filter(Boolean);
    const study = state.get('rows.study');
    const holds = (row, word) => (word.includes('=') ? `;${row.params};`.toLowerCase().includes(word)
        : [row.method, row.scene, row.view, row.split, row.status, row.study].join(' ').toLowerCase().includes(word));
    return view.run.table('rows.csv').lines.filter(row => view.isMethodShown(row.method) && isSceneShown(row) &&
        (study === 'all' || row.study === study) && words.every(word => holds(row, word)));
}

/// The chosen columns in the table's order, or the usual ones in theirs.
function rowsColumns(run) {
    const table = run.table('rows.csv');
    const chosen = state.get('rows.columns');
    const names = chosen.length ? table.names.filter(name => chosen.includes(name))
        : ROWS_USUAL.filter(name => table.has(name));
    return names.map(name => {
        const {unit, doc} = ((window.columnDocs || {})['rows.csv'] || {})[name] || {unit: '', doc: ''};
        const isTime = unit.startsWith('ns');
        return {
            key: name, title: name.replace(/_/g, ' ').replace(/ ns\b/, ' ms'), isText: ROWS_TEXT.includes(name),
            help: doc + (unit && !isTime ? `, ${unit}` : ''),
            value: row => row[name], text: row => rowsText(row[name], unit, isTime),
            rows: name === 'f_2px' ? row => (row.status === 'ok' ? [row] : []) : undefined,
        };
    });
}

/// A field as it is shown: shares with three digits, times in ms.
function rowsText(value, unit, isTime) {
    if (value === null || value === undefined) return NOTHING;
    if (!isNumber(value)) return String(value);
    if (isTime) return formatMs(value * 1e-6);
    if (unit === '0..1') return formatShare(value);
    return Number.isInteger(value) ? String(value) : formatNumber(value);
}

function rowsTools(view, show, number) {
    const run = view.run;
    const studies = rowsStudies(run);
    const search = element('input', {type: 'search', id: 'filter-rows', placeholder: 'method, scene, key=value …',
        value: state.get('rows.text'),
        'aria-label': 'Text that rows must hold', oninput: event => {
            state.set({'rows.text': event.target.value});
            show();
        }});
    return element('div', {class: 'tools'},
        element('label', {class: 'field'}, element('span', {}, 'Filter'), search),
        studies.length > 1 ? chooser('Study', [['all', 'all'], ...studies.map(name => [name, name])],
            state.get('rows.study'),
            study => state.set({'rows.study': study})) : null,
        rowsColumnPicker(run),
        element('button', {type: 'button', class: 'quiet', onclick: () => {
            const names = run.table('rows.csv').names;
            saveFile('rows.csv', 'text/csv',
                csvText([names, ...rowsLeft(view).map(row => names.map(name => row[name]))]));
        }}, 'Everything as CSV'), number);
}

function rowsColumnPicker(run) {
    const names = run.table('rows.csv').names;
    const shown = state.get('rows.columns').length ? state.get('rows.columns') : ROWS_USUAL;
    const docs = (window.columnDocs || {})['rows.csv'] || {};
    const choose = list => state.set({'rows.columns': list});
    return element('details', {class: 'picker', 'data-name': 'rows-columns'},
        element('summary', {}, 'Columns',
            element('b', {}, ` ${names.filter(name => shown.includes(name)).length} of ${names.length}`)),
        element('div', {class: 'picker-list'},
            element('div', {class: 'tools'},
                element('button', {type: 'button', onclick: () => choose([])}, 'Usual'),
                element('button', {type: 'button', onclick: () => choose(names)}, 'All')),
            names.map(name => element('label', {title: (docs[name] || {}).doc}, element('input', {
                type: 'checkbox', value: name, checked: shown.includes(name),
                onchange: event => choose(names.filter(other => (other === name ? event.target.checked
                    : shown.includes(other)))),
            }), ' ', name))));
}
