// Lines of tables, sorted by the method they are about, and added up.

/// Lines by method: [{name, info, isBaseline, lines}] in the order of the run's methods, baselines
/// last. Methods without a line are left out.
function byMethod(run, lines) {
    const groups = groupBy(lines, line => line.method);
    const known = [...run.methods.values()].filter(info => groups.has(info.name));
    const ordered = [...known.filter(info => !info.isBaseline), ...known.filter(info => info.isBaseline)];
    return ordered.map(info => ({
        name: info.name, info, isBaseline: info.isBaseline, lines: groups.get(info.name),
    }));
}

/// The sum of a field over lines; empty fields count nothing.
function sumOf(lines, field) {
    let sum = 0;
    for (const line of lines) sum += line[field] || 0;
    return sum;
}

/// A share of sums; null where there is nothing to divide by.
function shareOf(part, whole) {
    return whole > 0 ? part / whole : null;
}

/// The median of values; null without any.
function medianOf(values) {
    return quantile(ascending(values), 0.5);
}

/// The columns that every table by method begins with.
function infoColumn() {
    return methodColumn(line => line.info);
}

/// Lines about baselines are grey.
function baselineClass(line) {
    return line.isBaseline ? 'baseline' : null;
}

// ---- Settings ------------------------------------------------------------------------------

/// The columns of sweep.csv that are parameters.
function sweptParams(run) {
    const names = run.table('sweep.csv').names;
    return names.slice(names.indexOf('status') + 1, names.indexOf('f_2px'));
}

/// The values of all swept parameters of a line of sweep.csv, as one text; made once, since there are many.
function settingKey(run, line) {
    run.settingKeys ??= new Map();
    if (!run.settingKeys.has(line)) run.settingKeys.set(line, sweptParams(run).map(name => line[name]).join(';'));
    return run.settingKeys.get(line);
}

/// Whether two values of a parameter are the same, as texts or as numbers.
function isSameValue(a, b) {
    return String(a) === String(b) || (a !== '' && b !== null && Number(a) === Number(b));
}

/// A parameter's value without the digits that rounding leaves.
function paramWords(value) {
    return isNumber(value) ? String(Number(value.toPrecision(6))) : String(value);
}

/// What a setting changes of its method's own: "clip_bits=3, threshold=20"; "" if nothing.
function changedParams(info, params, values) {
    return params.filter(name => values[name] !== null && !isSameValue(info.params[name], values[name]))
        .map(name => `${name}=${paramWords(values[name])}`).join(', ');
}
