// Settings: what a sweep over parameters found, for one method and one parameter at a time.

state.define('settings.method', '');
state.define('settings.param', '');
state.define('settings.log', false);

addSection({
    id: 'settings',
    title: 'Settings',
    intro: 'Every method was drawn with several settings of its parameters. Here are the best of them, and how the measure ' +
        'and time change with one parameter.',
    isThere: isSwept,
    uses: ['settings.*', 'sort.settings*'],
    draw(root, view) {
        const methods = sweptMethods(view);
        const {title} = MEASURES[settingsMeasure(view)];
        settingsTable(root, methods, title);
        settingsCharts(root, methods, title);
    },
});

/// What settings are told apart by: soft F if it is chosen and was scored of them, else F.
function settingsMeasure(view) {
    return view.measure === 'soft_f' && view.run.table('sweep.csv').has('soft_f') ? 'soft_f' : 'f_2px';
}

function sweptLines(view) {
    return view.run.joined('sweep.csv').filter(line => view.isMethodShown(line.method) && isSceneShown(line) && line.status === 'ok');
}

/// Whether a method has several settings with a score: found long before they are summed.
function isSwept(view) {
    const first = new Map();
    return sweptLines(view).some(line => {
        if (!isNumber(line.k_2px) || view.run.methods.get(line.method).isBaseline) return false;
        const key = settingKey(view.run, line);
        if (!first.has(line.method)) first.set(line.method, key);
        return first.get(line.method) !== key;
    });
}

/// Swept methods: {name, info, params: those that vary, settings: [{values, f, ms, views, rows}], own}.
function sweptMethods(view) {
    const lines = sweptLines(view);
    const names = sweptParams(view.run);
    const measure = settingsMeasure(view);
    return byMethod(view.run, lines).filter(method => !method.isBaseline).map(method => {
        const groups = [...groupBy(method.lines, line => settingKey(view.run, line)).values()];
        const values = name => distinct(groups, ([line]) => line[name]).length;
        const params = names.filter(name => values(name) > 1).sort((a, b) => values(b) - values(a));
        const settings = groups.map(lines => sweptSetting(method, params, lines, measure)).filter(setting => setting.f !== null);
        return {...method, params, settings, own: settings.find(setting => setting.isOwn) || null};
    }).filter(method => method.settings.length > 1);
}

function sweptSetting(method, params, lines, measure) {
    const values = Object.fromEntries(params.map(name => [name, lines[0][name]]));
    const scored = lines.filter(line => isNumber(line.k_2px));
    return {
        values, lines,
        f: pooled(scored, measure),
        ms: medianOf(lines.map(line => (isNumber(line.draw_ns) ? line.draw_ns * 1e-6 : null))),
        isOwn: params.every(name => isSameValue(method.info.params[name], values[name])),
        words: changedParams(method.info, params, values) || 'its own setting',
    };
}

function bestSetting(settings) {
    return settings.reduce((a, b) => (b.f > a.f || (b.f === a.f && b.ms < a.ms) ? b : a));
}

function settingsTable(root, methods, title) {
    const lines = methods.map(method => ({...method, best: bestSetting(method.settings)}));
    makeTable(root, {
        name: 'settings', lines, order: 'f_best.down',
        columns: [
            infoColumn(), {key: 'settings', title: 'settings', value: line => line.settings.length},
            shareColumn('f_own', `${title}, own setting`, line => (line.own ? line.own.f : null)),
            shareColumn('f_best', `${title}, best setting`, line => line.best.f),
            {key: 'gain', title: 'gain', value: line => (line.own ? line.best.f - line.own.f : null),
                text: line => formatSigned(line.own ? line.best.f - line.own.f : null)},
            {key: 'ms', title: 'its ms', value: line => line.best.ms, text: line => formatMs(line.best.ms),
                best: 'low'},
            {key: 'setting', title: 'best setting', isText: true, value: line => line.best.words,
                node: line => element('code', {}, line.best.words)},
        ],
    });
}

function settingsCharts(root, methods, title) {
    const withParams = methods.filter(method => method.params.length);
    if (withParams.length === 0) return;
    const method = withParams.find(m => m.name === state.get('settings.method')) || withParams[0];
    const param = method.params.includes(state.get('settings.param')) ? state.get('settings.param') : method.params[0];
    root.append(element('div', {class: 'tools'},
        chooser('Method', withParams.map(m => [m.name, m.name]), method.name,
            name => state.set({'settings.method': name, 'settings.param': ''})),
        chooser('Parameter', method.params.map(name => [name, name]), param,
            name => state.set({'settings.param': name})),
        choiceButtons('Scale of time', [[false, 'Linear time'], [true, 'Logarithmic time']], state.get('settings.log'),
            log => state.set({'settings.log': log}))),
        element('p', {class: 'note'},
            'One dot per setting. The line joins the best of each value, whatever the other parameters are. A ' +
            'ring marks the method’s own setting.'));
    const grid = chartGrid();
    root.append(grid);
    settingsChart(grid, method, param, {id: 'f', title: `${title} over ${param}`, unit: title,
        value: setting => setting.f, best: d3.max, text: f => `${title} ${formatShare(f)}`});
    settingsChart(grid, method, param, {id: 'ms', title: `Time over ${param}`, unit: 'median frame, ms',
        value: setting => setting.ms, best: d3.min, text: ms => `${formatMs(ms)} ms`});
}

function settingsChart(grid, method, param, {id, title, unit, value, best, text}) {
    const shown = method.settings.filter(setting => isNumber(value(setting)) && setting.values[param] !== null);
    if (shown.length === 0) return;
    makeChart(grid, {
        id: `settings-${id}`, title, height: 300, least: 300,
        draw: chart => {
            const area = plotArea(chart, {top: 26, right: 14, bottom: 46, left: 52});
            const {scale: x, ticks} = paramScale(shown.map(setting => setting.values[param]), area.width);
            const isLog = id === 'ms' && state.get('settings.log');
            const y = makeScale(shown.map(value), [area.height, 0], {isLog, includesZero: id === 'ms' && !isLog});
            drawAxes(area, x, y, {bottom: {title: param, ticks, format: paramText},
                left: {title: unit + (isLog ? ', logarithmic' : ''), isLog}});
            const at = setting => x(paramKey(setting.values[param], x));
            const joined = [...groupBy(shown, at)].map(([px, ofValue]) => [px, best(ofValue, value)])
                .sort((a, b) => a[0] - b[0]);
            if (!x.step) {
                area.plot.append('path').attr('d', pathThrough(joined, p => p[0], p => y(p[1]))).style('fill', 'none')
                    .style('stroke', colourOf(method.info)).style('stroke-width', 1.7);
            }
            const layer = area.plot.append('g');
            const spots = shown.map(setting => ({px: at(setting), py: y(value(setting)), line: {name: ''},
                point: {text: [text(value(setting)), setting.words]}, setting}));
            for (const spot of spots)
                layer.append('circle').attr('cx', spot.px).attr('cy', spot.py).attr('r', 3)
                    .style('fill', colourOf(method.info)).style('opacity', 0.55);
            for (const spot of spots.filter(s => s.setting.isOwn))
                layer.append('circle').attr('cx', spot.px).attr('cy', spot.py).attr('r', 6).style('fill', 'none')
                    .style('stroke', 'var(--ink)').style('stroke-width', 1.6);
            answerNearest(area.plot, layer, spots, area.width, area.height);
        },
        csv: () => [[...method.params, 'f', 'draw_ms'],
            ...shown.map(setting => [...method.params.map(name => setting.values[name]), setting.f, setting.ms])],
    });
}
