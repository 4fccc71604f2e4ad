// The verdict: a line per method, every column sorts.

addSection({
    id: 'verdict',
    isMain: true,
    title: 'Verdict',
    intro: view => 'Counts of all views are pooled. F is the harmonic mean of precision and recall of one-to-one ' +
        'matches between drawn and true pixels' + (hasInk() ? ', soft F that of their ink' : '') + '. Bold: best of its column. Grey lines are baselines: none (an empty image), ' +
        'sampled (one exact sample a pixel, at its centre), exact_corner (one at its corner), oracle (the truth itself).',
    isThere: view => view.run.rows.length > 0,
    uses: ['sort.verdict'],
    draw(root, view) {
        for (const text of view.isWhole ? view.run.words.warnings : []) root.append(element('p', {class: 'note'}, text.replaceAll('`', '')));
        noteSums(root, view);
        const classes = RECALL_GROUPS.filter(name => view.summaries.some(s => s.classes[name] !== null));
        const rowsOf = line => (line.isBaseline ? null : line.rows);
        const title = MEASURES[view.measure].title;
        const columns = [
            methodColumn(line => line.info, {rows: rowsOf}),
            shareColumn('value', title, line => line.value, {rows: rowsOf}),
            {key: 'range', title: view.run.interval, value: line => (line.range ? line.range.low : null),
             text: line => formatRange(line.range), help: 'Scenes are drawn anew with replacement, each with all its views; none with fewer than six'},
            shareColumn('train', 'training', line => line.train, {help: 'Over the training scenes'}),
            shareColumn('heldout', 'held-out', line => line.heldout, {help: 'Over scenes that no setting was tuned on'}),
            shareColumn('real', 'real models', line => line.real, {help: 'Over model files; the other scenes are made by code'}),
            shareColumn('macro', 'mean of scenes', line => line.macro, {help: 'Every scene counts alike'}),
            shareColumn('kinds', 'mean of kinds', line => line.kinds, {help: 'Every kind of scene counts alike'}),
            ...(view.measure === 'soft_f' ? [shareColumn('f_2px', 'F at 2 px', line => line.f_2px)] : []),
            shareColumn('f_1px', 'F at 1 px', line => line.f_1px),
            shareColumn('precision', 'precision', line => line.precision),
            shareColumn('recall', 'recall', line => line.recall),
            ...classes.map(name => shareColumn(`recall_${name}`, groupTitle(name), line => line.classes[name], {group: 'recall by class of line'})),
            {key: 'width_px', title: 'width px', value: line => line.width_px, text: line => formatNumber(line.width_px)},
            {key: 'ms', title: 'draw ms', value: line => (line.info.hasOwnClock ? null : line.ms), text: line => formatMs(line.ms) + (line.info.hasOwnClock && line.ms !== null ? ' (own clock)' : ''), best: 'low',
             help: 'Median over views of the lower quartile of the processor time of a frame at the best speed of the machine, of several threads of its time on the wall; of methods from outside, by their own clock', hint: line => (line.msRange ? `quartiles ${formatMs(line.msRange.low)} to ${formatMs(line.msRange.high)} ms` : '')},
            {key: 'bytes', title: 'B/px', value: line => line.bytes, text: line => line.bytes ?? NOTHING, best: 'low', help: 'Bytes a pixel of all buffers, depth included'},
            {key: 'views', title: 'views', value: line => line.views,
             text: line => (line.failed ? `${line.views} of ${line.views + line.failed}` : String(line.views))},
        ].filter(column => !['train', 'heldout', 'real', 'kinds'].includes(column.key) || view.summaries.some(s => s[column.key] !== null));
        makeTable(root, {
            name: 'verdict', columns, order: 'value.down', lines: view.summaries,
            lineClass: line => [line.isBaseline ? 'baseline' : '', line === view.best ? 'winner' : '',
                                view.isAffordable(line) || line.isBaseline ? '' : 'too-dear'].join(' ').trim(),
        });
    },
});
