// Every scene, or kind of scene, and method in one table: where a method is weak.

/// Lines of `keyOf` with a column per method: F of the group's views pooled.
function drawGroups(root, view, {name, title, keyOf, others}) {
    const methods = [...view.contestants].sort((a, b) => b.value - a.value);
    const lines = [...groupBy(view.rows.filter(keyOf), keyOf)].map(([key, rows]) => {
        const ofMethod = new Map(methods.map(s => [s.method, rows.filter(row => row.method === s.method)]));
        const values = new Map([...ofMethod].map(([method, own]) => [method, pooled(own, view.measure)]));
        return {key, all: rows, rows: ofMethod, values, best: d3.max([...values.values()].filter(isNumber)),
                mean: d3.mean([...values.values()].filter(isNumber))};
    });
    const errorOf = value => (isNumber(value) ? 1 - value : null);
    const worst = Math.max(0.1, 1 - d3.min(lines.flatMap(line => [...line.values.values()].filter(isNumber))));
    const columns = [
        {key: name, title, isText: true, value: line => line.key},
        ...others,
        {key: 'mean', title: 'mean', value: line => line.mean, text: line => formatShare(line.mean)},
        ...methods.map(s => ({
            key: s.method, title: s.method,
            value: line => line.values.get(s.method),
            node: line => {
                const text = formatShare(line.values.get(s.method));
                return element(text !== NOTHING && text === formatShare(line.best) ? 'b' : 'span', {}, text);
            },
            css: line => errorShade(errorOf(line.values.get(s.method)), worst),
            rows: line => line.rows.get(s.method),
        })),
    ];
    makeTable(root, {name, columns, lines, order: 'mean.up', caption: MEASURES[view.measure].title});
}

addSection({
    id: 'kinds',
    title: 'By kind of scene',
    intro: 'The views of a kind’s scenes pooled; the redder, the more is wrong. The mean of kinds counts them alike.',
    isThere: view => distinct(view.rows, row => row.scene_kind).filter(Boolean).length > 1 && view.contestants.length > 0,
    uses: ['sort.kinds'],
    draw(root, view) {
        const scenesOf = line => distinct(line.all, row => row.scene).length;
        drawGroups(root, view, {name: 'kinds', title: 'kind', keyOf: row => row.scene_kind, others: [
            {key: 'scenes', title: 'scenes', value: scenesOf, text: line => formatNumber(scenesOf(line))}]});
    },
});

addSection({
    id: 'scenes',
    title: 'By scene',
    intro: 'A scene’s views pooled; the redder, the more is wrong; hatched: no score. Point at a cell for its worst image; a click keeps it.',
    isThere: view => view.scenes.length > 0 && view.contestants.length > 0,
    uses: ['sort.scenes'],
    draw(root, view) {
        const truth_px = ({all}) => d3.sum(distinct(all, row => row.view), name => all.find(row => row.view === name).truth_px);
        const hasKinds = view.rows.some(row => row.scene_kind);
        drawGroups(root, view, {name: 'scenes', title: 'scene', keyOf: row => row.scene, others: [
            ...(hasKinds ? [{key: 'kind', title: 'kind', isText: true, value: line => line.all[0].scene_kind}] : []),
            {key: 'split', title: 'split', isText: true, value: line => line.all[0].split, text: line => splitTitle(line.all[0].split)},
            {key: 'truth_px', title: 'true px', value: truth_px, text: line => formatNumber(truth_px(line))}]});
    },
});
