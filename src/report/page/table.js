// Tables that sort, answer the pointer, and leave as CSV.

/// Names of the tables of which the reader asked for all lines.
const wholeTables = new Set();

/// A table of `lines`. A column is {key, title, value(line), text(line), help, align, group, node(line),
/// best: 'high' | 'low', css(line), rows(line)}: `value` is what is sorted and saved, `text` what is shown,
/// `node` an element in its place; `rows` gives the rows whose images the card shows when the
/// pointer is on the cell.
/// `name` is the part of the address in which the order is kept, and of the file that is saved.
function makeTable(parent, {name, columns, lines, lineClass, order = '', caption, most = 0}) {
    state.define(`sort.${name}`, order);
    const asked = state.get(`sort.${name}`);
    const [key, direction] = asked.split('.');
    const sortedBy = columns.find(column => column.key === key);
    const shown = sortedBy ? sortLines(lines, sortedBy, direction === 'down') : lines;
    const best = bestLines(columns, lines);

    const head = element('tr', {}, columns.map(column => headCell(name, column, key, direction)));
    const groups = groupHeads(columns);
    const body = element('tbody', {});
    const limit = most && shown.length > most && !wholeTables.has(name) ? most : shown.length;
    const append = (from, to) => {
        for (const line of shown.slice(from, to)) {
            body.append(element('tr', {class: lineClass ? lineClass(line) : null},
                columns.map((column, index) => bodyCell(column, line, index, best))));
        }
    };
    append(0, limit);
    const table = element('table', {class: 'data'},
        caption ? element('caption', {}, caption) : null,
        element('thead', {}, groups, head), body);
    const scroller = element('div', {class: 'scroll', tabindex: '0', role: 'group', 'aria-label': `Table ${name}`}, table);
    parent.append(scroller);
    const more = limit < shown.length
        ? element('button', {type: 'button', onclick: event => {
            wholeTables.add(name);
            append(limit, shown.length);
            event.target.remove();
            scroller.focus({preventScroll: true});
        }}, `Show all ${shown.length} lines`) : null;
    parent.append(element('div', {class: 'tools'}, more,
        element('button', {type: 'button', class: 'quiet', onclick: () => saveFile(
            `${name}.csv`, 'text/csv', tableCsv(columns, shown))}, 'Save as CSV')));
    return table;
}

function tableCsv(columns, lines) {
    return csvText([columns.map(column => column.key),
                    ...lines.map(line => columns.map(column => column.value(line)))]);
}

/// Lines by a column; those without a value come last in either direction.
function sortLines(lines, column, isDescending) {
    const order = (a, b) => {
        const [x, y] = [column.value(a), column.value(b)];
        const isGone = v => v === null || v === undefined || Number.isNaN(v);
        if (isGone(x) || isGone(y)) return isGone(x) - isGone(y);
        const sign = typeof x === 'number' && typeof y === 'number'
            ? x - y : String(x).localeCompare(String(y), undefined, {numeric: true});
        return isDescending ? -sign : sign;
    };
    return [...lines].sort(order);
}

/// For each column that says so, the text of its best value; baselines do not count.
function bestLines(columns, lines) {
    const best = new Map();
    for (const column of columns.filter(c => c.best)) {
        const values = lines.filter(line => !line.isBaseline).map(column.value).filter(isNumber);
        if (values.length < 2) continue;
        const value = column.best === 'high' ? d3.max(values) : d3.min(values);
        const line = lines.find(l => !l.isBaseline && column.value(l) === value);
        best.set(column, column.text ? column.text(line) : String(value));
    }
    return best;
}

function headCell(name, column, key, direction) {
    const isSorted = column.key === key;
    const turn = () => {
        // Numbers are looked at from the largest down first, names from A.
        const first = column.isText ? 'up' : 'down';
        const other = first === 'up' ? 'down' : 'up';
        state.set({[`sort.${name}`]: `${column.key}.${isSorted && direction === first ? other : first}`});
    };
    return element('th', {
        scope: 'col',
        class: [column.isText ? 'text' : '', column.startsGroup ? 'group' : ''].join(' ').trim() || null,
        'aria-sort': isSorted ? (direction === 'down' ? 'descending' : 'ascending') : 'none',
        title: column.help || null,
    }, element('button', {type: 'button', onclick: turn}, column.title,
               element('span', {class: 'order', 'aria-hidden': 'true'},
                       isSorted ? (direction === 'down' ? ' ▾' : ' ▴') : '')));
}

/// The line above the headings, if columns stand in groups.
function groupHeads(columns) {
    if (!columns.some(column => column.group)) return null;
    const cells = [];
    for (const column of columns) {
        const last = cells[cells.length - 1];
        if (last && last.name === (column.group || '')) ++last.span;
        else {
            cells.push({name: column.group || '', span: 1});
            if (column.group) column.startsGroup = true;
        }
    }
    return element('tr', {class: 'groups'}, cells.map(cell => element(cell.name ? 'th' : 'td',
        {colspan: cell.span, scope: cell.name ? 'colgroup' : null}, cell.name)));
}

function bodyCell(column, line, index, best) {
    const text = column.node ? null : column.text ? column.text(line) : String(column.value(line) ?? NOTHING);
    const isBest = best.has(column) && !line.isBaseline && text === best.get(column);
    const cell = element(index === 0 ? 'th' : 'td', {
        scope: index === 0 ? 'row' : null,
        class: [column.isText ? 'text' : '', column.startsGroup ? 'group' : '', isBest ? 'best' : '']
            .join(' ').trim() || null,
        style: column.css ? column.css(line) : null,
        title: column.hint ? column.hint(line) : null,
    }, column.node ? column.node(line) : text);
    const rows = column.rows ? column.rows(line) : null;
    if (rows && rows.length) answerPointer(cell, rows);
    return cell;
}

/// A column of shares, 0..1.
function shareColumn(key, title, value, more = {}) {
    return {key, title, value, text: line => formatShare(value(line)), best: 'high', ...more};
}

/// A method's name with its marker.
function methodColumn(infoOf, more = {}) {
    return {
        key: 'method', title: 'method', isText: true, value: line => infoOf(line).name,
        node: line => methodName(infoOf(line)), ...more,
    };
}

function methodName(info) {
    return element('span', {class: 'method'}, markerImage(info), info.name);
}

/// A method's marker as a small drawing; hollow for settings that the tuner found.
function markerImage(info) {
    const drawing = d3.create('svg').attr('viewBox', '-7 -7 14 14').attr('class', 'marker')
        .attr('aria-hidden', 'true');
    drawing.append('path').attr('d', markerOf(info)).call(markerStyle, info);
    return drawing.node();
}

function markerStyle(path, info) {
    path.style('fill', info.presetOf ? 'var(--paper)' : colourOf(info))
        .style('stroke', colourOf(info)).style('stroke-width', 1.4);
}
