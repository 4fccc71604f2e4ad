// What the page says first: the verdict in a sentence, and whatever must be known before any number
// is read.

function drawHeader(root, view) {
    const {run, best} = view;
    root.replaceChildren(...[
        element('div', {class: 'brand'}, element('strong', {}, 'Inkbench'),
            element('span', {}, 'Which outline method makes the fewest errors at a time budget?')),
        ...[invalidWarning, missingWarning].map(make => make(view)),
        element('h1', {}, headline(view)),
        unscoredWarning(),
        run.rows.length ? element('p', {class: 'lead'}, ...verdictSentences(view)) : element('p', {class: 'lead'}, runWords(run)),
        best && runs.length === 1 ? element('p', {class: 'soft paper-sentence'}, element('b', {}, 'For a paper: '), paperSentence(view)) : null,
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
    const {run} = view;
    if (runs.length > 1) return `${runs.length} runs beside each other: ${runs.map(r => r.label).join(', ')}`;
    if (run.rows.length) return answerWords(view)[0];
    return run.record.name === run.record.kind ? run.record.kind : `${run.record.kind}: ${run.record.name}`;
}

function verdictSentences(view) {
    const {best, contestants} = view;
    if (!best) return contestants.length ? [] : ['No method is left by these filters.'];
    const [first, rest] = answerWords(view);
    const most = d3.greatest(contestants, s => s.value);
    const words = [runs.length > 1 ? `${view.run.label}: ${first}. ${rest} ` : `${rest} `,
        `${measureWord(view.measure)} is at ${view.measure === 'f_1px' ? 1 : 2} px, over ${count(most.views, 'view')} of ${count(most.scenes, 'scene')} pooled. `,
        partWords(contestants)];
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
        [MEASURES[view.measure].title, formatShare(best.value)],
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
