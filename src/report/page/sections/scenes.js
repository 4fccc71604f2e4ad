// Every scene and method in one table: where a method is weak.

addSection({
    id: 'scenes',
    title: 'By scene',
    intro: 'A scene’s views pooled; the redder, the more is wrong; hatched: no score. Point at a cell for its worst image; a click keeps it.',
    isThere: view => view.scenes.length > 0 && view.contestants.length > 0,
    uses: ['sort.scenes'],
    draw(root, view) {
        const methods = [...view.contestants].sort((a, b) => b.value - a.value);
        const lines = [...groupBy(view.rows, row => row.scene)].map(([scene, rows]) => {
            const ofMethod = new Map(methods.map(s => [s.method, rows.filter(row => row.method === s.method)]));
            const values = new Map([...ofMethod].map(([name, own]) => [name, pooled(own, view.measure)]));
            const best = d3.max([...values.values()].filter(isNumber));
            return {scene, split: rows[0].split, rows: ofMethod, values, best,
                    mean: d3.mean([...values.values()].filter(isNumber)),
                    truth_px: d3.sum(distinct(rows, row => row.view), name => rows.find(row => row.view === name).truth_px)};
        });
        const errorOf = value => (isNumber(value) ? 1 - value : null);
        const worst = Math.max(0.1, 1 - d3.min(lines.flatMap(line => [...line.values.values()].filter(isNumber))));
        const columns = [
            {key: 'scene', title: 'scene', isText: true, value: line => line.scene},
            {key: 'split', title: 'split', isText: true, value: line => line.split, text: line => splitTitle(line.split)},
            {key: 'truth_px', title: 'true px', value: line => line.truth_px, text: line => formatNumber(line.truth_px)},
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
        makeTable(root, {name: 'scenes', columns, lines, order: 'mean.up', caption: MEASURES[view.measure].title});
    },
});
