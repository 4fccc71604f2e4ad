// What the page says first: the finding, why, what it is and what to do with it; and whatever must be
// known before any number is read.

function drawHeader(root, view) {
    const {run, best, isWhole} = view;
    const isAlone = runs.length === 1 && isWhole && best !== null;
    const [lead, ...more] = run.rows.length ? leadWords(view) : [runWords(run)];
    root.replaceChildren(...[
        element('div', {class: 'brand'}, element('strong', {}, 'Inkbench'),
            element('span', {}, 'Which outline method makes the fewest errors at a time budget?')),
        ...[invalidWarning, missingWarning].map(make => make(view)),
        element('h1', {}, unbroken(headline(view))),
        element('div', {class: 'first'},
            element('div', {},
                lead ? element('p', {class: 'lead'}, unbroken(lead)) : null,
                isAlone ? answerWords(run.words.home, best) : null,
                unscoredWarning(),
                busyWarning(),
                best ? extentNote(view, more) : null),
            isAlone ? takeHome(run.words.home) : null),
    ].filter(Boolean));
}

/// A number stays on the line of its unit.
function unbroken(text) {
    return text.replace(/ (%|ms|px)/g, '\u00a0$1');
}

/// What the answer is.
function answerWords({method, address}, {method: name}) {
    const words = [element('b', {}, name), `: ${method}. `, address ? element('a', {href: address}, `More on ${name}`) : null];
    return method ? element('p', {class: 'what'}, words) : null;
}

/// What to do with it: commands to copy.
function takeHome({commands}) {
    return element('div', {class: 'take-home'}, element('h2', {}, 'Take it home'), commands.map(([what, line]) => element('p', {},
        element('span', {}, what), element('code', {}, line),
        element('button', {type: 'button', class: 'quiet', 'aria-label': `Copy ${line}`,
            onclick: event => copyText(line, 'command.txt', event.currentTarget)}, 'Copy'))));
}

/// Over how much it is, with what few need below.
function extentNote(view, more) {
    const {run, best, isWhole} = view;
    const words = `${count(view.contestants.length, 'method')}, ${count(best.views, 'view')} of ${scenesText(view, best.scenes)} ` +
        `with a score, ${run.rows[0].width} × ${run.rows[0].height} px`;
    if (!more.length) return element('p', {class: 'note'}, `${words}.`);
    return element('details', {class: 'more', 'data-name': 'more'}, element('summary', {}, `${words}: more`),
        more.map(text => element('p', {}, text)),
        runs.length === 1 && isWhole ? element('p', {class: 'paper-sentence'}, element('b', {}, 'For a paper: '), run.words.paper) : null);
}

function runWords(run) {
    const words = {stress: 'How errors grow along axes of difficulty.', animation: 'How methods behave in motion.',
                   tune: 'A search for better settings.'};
    return [words[run.record.kind], run.finding?.rest].filter(Boolean).join(' ');
}

function headline(view) {
    const {run} = view;
    if (runs.length > 1) return `${runs.length} runs beside each other: ${runs.map(r => r.label).join(', ')}`;
    if (run.rows.length) return view.isWhole ? run.words.first : answerOfSums(view);
    if (run.finding) return run.finding.first;
    return run.record.name === run.record.kind ? run.record.kind : `${run.record.kind}: ${run.record.name}`;
}

/// "1 scene", "4 models": models where all are model files.
function scenesText(view, number) {
    return count(number, view.allRows.every(row => row.split === 'real') ? 'model' : 'scene');
}

/// What stands below the headline, then what few need: of a whole run its own words, of filters that
/// there are none.
function leadWords(view) {
    const {run, contestants, isWhole} = view;
    const {first, rest, extent} = run.words;
    const front = paretoFront(contestants, s => s.ms, s => 1 - s.value).map(s => s.method);
    const more = [...(isWhole ? [extent] : []), ...(front.length > 1 ? [`No method is both faster and better than these: ${front.join(', ')}.`] : [])];
    const label = runs.length > 1 ? `${run.label}: ` : '';
    if (isWhole) return [runs.length > 1 ? `${label}${first}. ${rest}` : rest, ...more];
    const left = contestants.length ? 'A filter is set: these are sums alone.' : 'No method is left by these filters.';
    return [`${left} The answer of all is ${label}${first}.`, ...more];
}

function ofRunText(run) {
    return runs.length > 1 ? ` (${run.label})` : '';
}

function invalidWarning() {
    const faults = runs.flatMap(run => run.record.faults.map(fault => fault + ofRunText(run)));
    return faults.length
        ? warningBox('This run is invalid.', 'What must hold of every run does not:', faults, true) : null;
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

/// What a reason without a score comes down to, and what helps most: [what, try]. `same` are lines of
/// unscored.csv that begin alike.
function unscoredWords(same) {
    const {reason, remedy, run} = same[0];
    const {width, height} = run.rows[0];
    const at = `at ${width}x${height}`;
    const larger = `--size ${3 * width}x${3 * height}`;
    return {
        crowded: [`too dense ${at}`, larger],
        empty: [`without a line ${at}`, `another view, or ${larger}`],
        too_large: ['too large', 'a smaller --size or a larger --crease'],
        reference_disagreement: ['disputed between truth and cross-check', '--no-crosscheck'],
    }[reason.split(':')[0]] || [reason, remedy];
}

/// "house.glb, trees.glb: all views": where there is no score.
function unscoredPlaces(same, run) {
    const viewsOf = scene => distinct(run.rows.filter(row => row.scene === scene), row => row.view).length;
    const scenes = [...groupBy(same, line => line.scene)].map(([name, lines]) => {
        const views = distinct(lines, line => line.view).length;
        return {name, extent: same[0].method ? count(lines.length, 'cell') : views >= viewsOf(name) ? 'all views' : count(views, 'view')};
    });
    return [...groupBy(scenes, scene => scene.extent)].map(([extent, alike]) => {
        const names = alike.slice(0, 4).map(scene => scene.name).join(', ');
        return `${names}${alike.length > 4 ? ` and ${alike.length - 4} more` : ''}: ${extent}`;
    }).join('; ');
}

/// How many times are uncertain, as the terminal says it; null where none are.
function busyWarning() {
    const words = runs.flatMap(run => {
        const uncertain = run.rows.filter(row => row.time_doubt).length;
        const timed = run.rows.filter(row => row.draw_n > 0 && !['own', 'children'].includes(row.clock)).length;
        return uncertain ? [`busy machine: times of ${uncertain} of ${timed} cells are uncertain${ofRunText(run)}`] : [];
    });
    return words.length ? element('p', {class: 'note busy'}, `${words.join('; ')}.`) : null;
}

/// Views and cells without a score: a line for what they have in common, each one below.
function unscoredWarning() {
    const lines = runs.flatMap(run => run.table('unscored.csv').lines.map(line => ({...line, run})));
    if (!lines.length) return null;
    const kinds = [...groupBy(lines, line => `${line.run.index} ${Boolean(line.method)} ${line.reason.split(':')[0]}`).values()].map(same => {
        const [what, remedy] = unscoredWords(same);
        return `${unscoredPlaces(same, same[0].run)} ${what}${ofRunText(same[0].run)}; try ${remedy}.`;
    });
    const most = 2;
    const more = kinds.length > most ? ` And ${count(kinds.length - most, 'other reason')}.` : '';
    const items = lines.map(line => [`${line.scene} ${line.view}${line.method ? ` ${line.method}` : ''}${ofRunText(line.run)}`, line])
        .map(([place, {reason, remedy}]) => element('span', {}, element('strong', {}, place), `: ${reason}. `, element('em', {}, `Try: ${remedy}`)));
    const views = lines.filter(line => !line.method).length;
    return warningBox(views ? `${count(views, 'view')} without a score.` : 'Some methods failed on some views.',
                      kinds.slice(0, most).join(' ') + more, items);
}
