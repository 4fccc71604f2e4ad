// Tables of a run folder, as the program packed them into the page.
//
// A table's columns are one text in zlib's format, by base64. A packed column is an array; {constant:
// value}, the same value on every line; or {words: [...], at: [...]}, texts that repeat. An empty
// field is null, infinity the text 'inf'.

/// Unpacks the columns of all tables of the runs, which then are JSON.
function inflateTables(packedRuns) {
    return Promise.all(packedRuns.flatMap(run => Object.values(run.tables)).map(async table => {
        const {body} = await fetch(`data:;base64,${table.columns}`);
        table.columns = await new Response(body.pipeThrough(new DecompressionStream('deflate'))).text();
    }));
}

/// The values of a packed column, one a line.
function unpackColumn(packed, lineCount) {
    if (Array.isArray(packed)) return packed;
    if (packed.words) return packed.at.map(index => (index < 0 ? null : packed.words[index]));
    return new Array(lineCount).fill(packed.constant);
}

/// One table: columns by name, unpacked when they are first asked for.
class Table {
    constructor(name, packed) {
        this.name = name;
        this.lineCount = packed ? packed.lines : 0;
        this.json = packed ? packed.columns : '{}';
        this.unpacked = {};
        this.madeLines = null;
    }

    /// The packed columns by name, read when they are first asked for.
    get packed() {
        this.read ??= JSON.parse(this.json);
        this.json = null;
        return this.read;
    }

    get names() {
        return Object.keys(this.packed);
    }

    has(name) {
        return name in this.packed;
    }

    /// The values of a column; all null if the table has none of that name.
    column(name) {
        if (!(name in this.unpacked)) {
            this.unpacked[name] = unpackColumn(
                this.has(name) ? this.packed[name] : {constant: null}, this.lineCount);
        }
        return this.unpacked[name];
    }

    /// The lines as objects, a property a column.
    get lines() {
        return this.madeLines ??= this.makeLines({});
    }

    /// Lines with the fields of `beneath` beneath their own.
    makeLines(beneath) {
        const columns = this.names.map(name => this.column(name));
        // Browsers keep an object of a hundred fields in a slow form unless one function names them all.
        const Line = new Function('columns', 'line',
            this.names.map((name, i) => `this[${JSON.stringify(name)}] = columns[${i}][line]`).join(';'));
        Line.prototype = beneath;
        return Array.from({length: this.lineCount}, (_, line) => new Line(columns, line));
    }
}

/// One run: its record, its tables, its methods.
class Run {
    constructor(packed, index) {
        this.index = index;
        this.label = packed.label;
        this.record = packed.record;
        // The program's: {first, rest, extent, paper, warnings} of verdict.md, {interval, home}; null of no comparison.
        this.words = packed.words;
        this.finding = packed.finding;  // of a run that compares nothing: {first, rest}, or null
        this.live = new Map(Object.entries(packed.live));  // address of a scene's page for the reader's GPU
        this.tables = {};
        for (const [name, table] of Object.entries(packed.tables))
            this.tables[name] = new Table(name, table);
        this.cells = new Map();
        for (const row of this.table('rows.csv').lines) this.cells.set(row.cell, row);
        this.rows = this.mainRows();
        this.methods = this.readMethods();
        this.joinedTables = {};
    }

    /// A table of the run; one without lines if the run has none of that name.
    table(name) {
        return this.tables[name] || new Table(name, null);
    }

    has(name) {
        return this.table(name).lineCount > 0;
    }

    /// What intervals over its scenes are called, by what they are worth.
    get interval() {
        return this.words?.interval ?? 'interval';
    }

    /// The rows of the comparison itself, at the first size and number of threads: no one time of a
    /// method means anything over several.
    mainRows() {
        const rows = this.table('rows.csv').lines.filter(row => row.study === 'compare');
        if (rows.length === 0) return rows;
        const {width, height, threads} = rows[0];
        return rows.filter(
            row => row.width === width && row.height === height && row.threads === threads);
    }

    readMethods() {
        const listed = new Map();
        for (const line of this.table('methods.csv').lines) {
            listed.set(line.method, {
                name: line.method,
                isBaseline: line.role !== 'method' && line.role !== 'entrant',
                hasOwnClock: line.role === 'entrant',
                family: line.family || 'other',
                marker: line.marker || 'circle',
                presetOf: line.preset_of || '',
                params: parseParams(line.params),
            });
        }
        const methods = new Map();
        for (const row of this.table('rows.csv').lines) {
            if (methods.has(row.method)) continue;
            methods.set(row.method, listed.get(row.method) || {
                name: row.method,
                isBaseline: BASELINES.includes(row.method),
                family: 'other',
                marker: 'circle',
                presetOf: '',
                params: parseParams(row.params),
            });
        }
        return methods;
    }

    /// The lines of a side table, each with the fields of its cell's row beneath its own.
    joined(name) {
        return this.joinedTables[name] ??= this.table(name).makeLines(this.cellFields(this.table(name)));
    }

    /// For lines that name a cell: the fields of its row which their table has not.
    cellFields(table) {
        const {cells} = this;
        const fields = this.table('rows.csv').names.filter(name => !table.has(name));
        return Object.create(null, Object.fromEntries(fields.map(name => [name, {get() { return cells.get(this.cell)?.[name]; }}])));
    }
}

const BASELINES = ['none', 'sampled', 'exact_corner', 'oracle'];
const CLASSES = VOCABULARY.classes.map(each => each.name);
const CLASS_PARTS = new Map(VOCABULARY.class_parts.map(part => [part.name, part]));

/// What recall is told of: the classes, or the parts of those that have parts.
const RECALL_GROUPS = CLASSES.flatMap(name => {
    const parts = [...CLASS_PARTS.values()].filter(part => part.class === name).map(part => part.name);
    return parts.length ? parts : [name];
});

function groupTitle(name) {
    return CLASS_PARTS.has(name) ? CLASS_PARTS.get(name).short : name;
}

/// "a=1;b=2" as an object.
function parseParams(text) {
    const params = {};
    for (const pair of (text || '').split(';')) {
        const at = pair.indexOf('=');
        if (at > 0) params[pair.slice(0, at)] = pair.slice(at + 1);
    }
    return params;
}

/// Lines grouped by what `key` gives: a Map in order of first appearance.
function groupBy(lines, key) {
    const groups = new Map();
    for (const line of lines) {
        const name = key(line);
        if (!groups.has(name)) groups.set(name, []);
        groups.get(name).push(line);
    }
    return groups;
}

/// Values of `key` over the lines, each once, in order of first appearance.
function distinct(lines, key) {
    return [...new Set(lines.map(key))];
}
