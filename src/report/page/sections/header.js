// What the page says first: the verdict in a sentence, and whatever must be known before any number
// is read.

function drawHeader(root, view) {
    const {run, best} = view;
    root.replaceChildren(...[
        element('div', {class: 'brand'}, element('strong', {}, 'Inkbench'),
            element('span', {}, 'Which outline method makes the fewest errors at a time budget?')),
        element('h1', {}, headline(view)),
        ...[invalidWarning, missingWarning, unscoredWarning].map(make => make(view)).filter(Boolean),
        run.rows.length ? element('p', {class: 'lead'}, ...verdictSentences(view)) : element('p', {class: 'lead'}, runWords(run)),
        best ? element('dl', {class: 'facts'}, headerFacts(view).map(([name, value, unit]) => element('div', {},
            element('dt', {}, name), element('dd', {}, value, unit ? element('small', {}, ` ${unit}`) : null)))) : null,
    ].filter(Boolean));
}

function runWords(run) {
    const words = {stress: 'How errors grow along axes of difficulty.', animation: 'How methods behave in motion.',
                   tune: 'A search for better settings.', bound: 'The best that four weights could reach.'};
    return words[run.record.kind] || '';
}

function headline(view) {
    const {best, run, measure} = view;
    const budget = state.get('budget');
    if (runs.length > 1) return `${runs.length} runs beside each other: ${runs.map(r => r.label).join(', ')}`;
    if (!best) return run.rows.length ? 'No method has a score here' : run.record.name === run.record.kind
        ? run.record.kind : `${run.record.kind}: ${run.record.name}`;
    const within = budget ? `Within ${formatMs(budget)} ms ` : '';
    const fewest = measure === 'f_2px' ? 'makes the fewest errors' : `is best in ${MEASURES[measure].title}`;
    return `${within}${best.method} ${fewest}`;
}

function verdictSentences(view) {
    const {best, ranked, contestants, measure} = view;
    if (!best) return ['No method is left by these filters.'];
    const words = [(runs.length > 1 ? `${view.run.label}: ${best.method} is best, ` : '') +
        `${MEASURES[measure].title} ${formatShare(best.value)}` +
        (best.range ? ` (95 % interval ${formatRange(best.range)})` : '') +
        ` over ${count(best.views, 'view')} of ${count(best.scenes, 'scene')}` +
        (best.ms ? `, ${formatMs(best.ms)} ms a frame. ` : '. ')];
    const second = ranked[1];
    if (second) {
        const others = ranked.filter(s => s !== best);
        const difference = pairedDifferences(others.map(s => s.rows), best.rows, measure)[others.indexOf(second)];
        if (difference && difference.range) {
            const range = difference.rangeOfAll || difference.range;
            const interval = `95 % interval ${formatSignedRange({low: -range.high, high: -range.low}, 4)}` +
                (difference.rangeOfAll ? ` for all ${others.length} others together` : '');
            words.push(isSignificant(difference)
                ? `It is ahead of ${second.method} by ${formatSigned(-difference.value, 4)} (${interval}). `
                : `Statistical tie with ${second.method}: difference ${formatSigned(-difference.value, 4)}, ${interval}. `);
        }
        if (best.scenes === 1) words.push('One scene gives no interval: this may be chance. ');
        else if (best.scenes < 5) words.push(`An interval from ${best.scenes} scenes is a rough one. `);
    }
    words.push(partWords(contestants));
    const front = paretoFront(contestants, s => s.ms, s => 1 - s.value).map(s => s.method);
    if (front.length > 1) words.push(`No method is both faster and better than these: ${front.join(', ')}.`);
    return words.filter(Boolean);
}

/// The best method of each part of the suite, or which the only part is: on what the verdict holds.
function partWords(contestants) {
    const parts = ['train', 'heldout', 'real'].map(split => {
        const own = contestants.filter(s => s[split] !== null);
        return {split, best: own[d3.maxIndex(own, s => s[split])]};
    }).filter(part => part.best);
    if (parts.length === 1) return `All scenes here are of one part: ${splitTitle(parts[0].split)}. `;
    return `Best by part: ${parts.map(({split, best}) =>
        `${splitTitle(split)} ${best.method} ${formatShare(best[split])}`).join(', ')}. `;
}

function headerFacts(view) {
    const {run, best} = view;
    const row = run.rows[0];
    return [
        ['best ' + MEASURES[view.measure].title, formatShare(best.value)],
        best.ms ? ['its frame', formatMs(best.ms), 'ms'] : null,
        ['methods', String(view.contestants.length)],
        ['scenes', String(view.scenes.length)],
        ['views with a score', `${best.views} of ${view.views}`],
        ['image', `${row.width} × ${row.height}`, 'px'],
    ].filter(Boolean);
}

function ofRunText(run) {
    return runs.length > 1 ? ` (${run.label})` : '';
}

function invalidWarning() {
    const faults = runs.flatMap(run => run.record.faults.map(fault => fault + ofRunText(run)));
    return faults.length
        ? warningBox('This run is invalid.', 'What must hold of every run does not:', faults) : null;
}

function missingWarning() {
    const unfinished = runs.filter(run => run.record.missing_blocks.length);
    if (!unfinished.length) return null;
    const most = 8;
    return warningBox('This run is not finished.', unfinished.map(run =>
        `${run.record.missing_blocks.length} of ${run.record.blocks} parts are missing${ofRunText(run)}. `).join('') +
        'Every number below is of the rest. The same command goes on where it stopped. Missing:',
    unfinished.flatMap(run => {
        const missing = run.record.missing_blocks;
        const named = missing.slice(0, most);
        if (missing.length > most) named.push(`and ${missing.length - most} more`);
        return named;
    }));
}

/// Views and cells without a score, each with its reason and what may help.
function unscoredWarning() {
    const lines = runs.flatMap(run => run.table('unscored.csv').lines.map(line => ({...line, run})));
    if (!lines.length) return null;
    const items = [...groupBy(lines, line => `${line.reason}\n${line.remedy}`).values()].map(same => {
        const names = same.map(line => `${line.scene} ${line.view}` + (line.method ? ` ${line.method}` : '') + ofRunText(line.run));
        const shown = names.slice(0, 12).join(', ') + (names.length > 12 ? ` and ${names.length - 12} more` : '');
        return [element('strong', {}, shown), `: ${same[0].reason} `, element('em', {}, `Try: ${same[0].remedy}`)];
    }).map(parts => element('span', {}, ...parts));
    const views = lines.filter(line => !line.method).length;
    return warningBox(views ? `${count(views, 'view')} without a score.` : 'Some methods failed on some views.',
                      'They enter no number here:', items);
}
