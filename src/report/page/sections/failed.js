// Cells that failed, with the reason and what may help.

addSection({
    id: 'failed',
    title: 'Failed cells',
    intro: 'Cells without a result. They enter no number and no chart.',
    isThere: view => failedRows(view).length > 0,
    uses: ['sort.failed'],
    draw(root, view) {
        const rows = failedRows(view);
        const remedies = failedRemedies(view.run);
        const views = distinct(rows, row => `${row.scene}\n${row.view}`).length;
        root.append(element('p', {}, `${count(rows.length, 'cell')} of ${count(views, 'view')} failed.`));
        makeTable(root, {
            name: 'failed', lines: rows, most: 30,
            columns: [
                {key: 'method', title: 'method', isText: true, value: row => row.method},
                {key: 'scene', title: 'scene', isText: true, value: row => row.scene},
                {key: 'view', title: 'view', isText: true, value: row => row.view},
                {key: 'study', title: 'study', isText: true, value: row => row.study},
                {key: 'status', title: 'what went wrong', isText: true, value: row => row.status},
                {key: 'remedy', title: 'what may help', isText: true, value: row => remedies(row)},
            ],
        });
    },
});

/// Rows of any study that the filters leave and that have no result.
function failedRows(view) {
    return view.run.table('rows.csv').lines.filter(
        row => row.status !== 'ok' && view.isMethodShown(row.method) && (row.study !== 'compare' || isSceneShown(row)));
}

/// What unscored.csv advises for a row; a line without a method is about the whole view.
function failedRemedies(run) {
    const known = new Map(run.table('unscored.csv').lines.map(
        line => [`${line.scene}\n${line.view}\n${line.method || ''}`, line.remedy]));
    return row => known.get(`${row.scene}\n${row.view}\n${row.method}`) ||
        known.get(`${row.scene}\n${row.view}\n`) || '';
}
