// The answer: which method, and what it is held against. The rule and the words are those of the
// program (src/summary/answer.cpp, src/report/text/answer_text.cpp), of what the filters leave; a test
// holds the sentences against verdict.md.

/// F is .01 below another where rounding leaves a little more.
const F_ROUNDING = 1e-9;

/// Two times of which neither is this many times the other are alike.
const ALIKE_TIMES = 1.15;

/// Of drawings of scenes those that name the answer, which is then given alone.
const STEADY_SHARE = 0.75;

/// Of the methods within the budget whose value is at most the margin below the best of them the cheapest
/// by the program's clock; of those whose times are alike, the most exact; of equals one that draws by
/// itself. The most exact itself where none such was timed.
function findAnswer(contestants, {margin, budget}) {
    const isCheaper = (a, b) => a.ms < b.ms || (a.ms === b.ms && a.value > b.value);
    const cheapest = lines => lines.reduce((a, b) => (a && !isCheaper(b, a) ? a : b), null);
    const isChoice = s => s.info.family === 'other';
    const isBefore = (a, b) => a.value > b.value || (a.value === b.value && !isChoice(a) && isChoice(b));
    const best = lines => lines.reduce((a, b) => (a && !isBefore(b, a) ? a : b), null);
    const hasOtherImages = (a, b) => a.images !== b.images;
    const within = contestants.filter(s => !budget || (s.ms !== null && s.ms <= budget));
    const mostExact = best(within);
    const asGood = within.filter(s => s.ms !== null && !s.info.hasOwnClock && mostExact.value - s.value <= margin + F_ROUNDING);
    const least = cheapest(asGood);
    const method = best(asGood.filter(s => s === least || s.ms < ALIKE_TIMES * least.ms)) || mostExact;
    const mayBeAsCheap = s => s.ms < ALIKE_TIMES * method.ms || (s.msDoubt && method.msDoubt && s.msDoubt.low < method.msDoubt.high);
    const others = within.filter(s => s !== mostExact);
    const next = best(others.filter(s => hasOtherImages(s, mostExact))) || best(others);
    return {
        method, mostExact, next, fastest: cheapest(contestants.filter(s => s.ms !== null)), other: method === mostExact ? next : mostExact,
        asCheap: asGood.filter(s => least && s !== method && hasOtherImages(s, method) && mayBeAsCheap(s)),
    };
}

/// The method that drawings of scenes name most often in place of the answer, and in which share, if they
/// name another in more than a quarter; else null. That of summary.csv where nothing is filtered.
function rivalOf(view) {
    const {method} = view.answer;
    if (!method || method.ms === null || view.measure !== 'f_2px') return null;
    const table = view.run.table('summary.csv');
    const share = !isFiltered() && table.has('answer_share')
        ? new Map(table.lines.map(line => [line.method, line.answer_share])) : drawnShares(view);
    if (!share || !isNumber(share.get(method.method)) || share.get(method.method) >= STEADY_SHARE) return null;
    const others = view.contestants.filter(s => s !== method && s.ms !== null && share.get(s.method) > 0);
    const most = others.reduce((a, b) => (a && share.get(a.method) >= share.get(b.method) ? a : b), null);
    return most && {line: most, share: share.get(most.method)};
}

/// In which share of drawings of scenes each method is the answer, as answer_shares() has it; null with
/// fewer than six scenes.
function drawnShares(view) {
    const scenes = sceneNames(view.rows);
    if (scenes.length < FEWEST_SCENES) return null;
    const sides = view.contestants.map(s => scenesOf(s.rows, view.measure, scenes).side);
    const drawn = view.contestants.map(s => ({...s}));
    const shares = new Map(view.contestants.map(s => [s.method, 0]));
    for (const drawing of drawingsOf(scenes.length, view.rows[0].seed)) {
        sides.forEach((side, i) => {
            weigh(side, drawing);
            drawn[i].value = side.value;
        });
        const named = findAnswer(drawn, {margin: state.get('margin'), budget: state.get('budget')}).method.method;
        shares.set(named, shares.get(named) + 1 / RESAMPLES);
    }
    return shares;
}

/// "F", or what else is measured.
function measureWord(measure) {
    return measure === 'f_2px' ? 'F' : MEASURES[measure].title;
}

/// "1 scene", "4 models": models where all are model files.
function scenesText(view, number) {
    return count(number, view.allRows.every(row => row.split === 'real') ? 'model' : 'scene');
}

/// "72 % of its error in bars"; "" where it does not sit in one scene.
function errorSceneText(view, line) {
    return view.measure === 'f_2px' && isErrorInOneScene(line)
        ? `${(100 * line.errorShare).toFixed(0)} % of its error in ${line.errorScene}` : '';
}

/// " in 1.60 ms"; "" without a time.
function timeText(word, line) {
    return line.ms === null ? '' : ` ${word} ${formatMs(line.ms)} ms${line.info.hasOwnClock ? ' by its own clock' : ''}`;
}

/// "+0.012 [+0.002, +0.021]"; a digit more where an end would round to 0.
function differenceText({value, range}) {
    const least = 0.5e-3;
    const digits = !range || (Math.abs(range.low) >= least && Math.abs(range.high) >= least) ? 3 : 4;
    const signed = number => (number < 0 ? '-' : '+') + fixed(Math.abs(number), digits);
    return signed(value) + (range ? ` [${signed(range.low)}, ${signed(range.high)}]` : '');
}

/// What the interval of a difference is, or why there is none.
function intervalSentence(view, difference) {
    const scenes = scenesText(view, difference.scenes);
    if (difference.range)
        return ` The 95 % interval is resampled over these ${scenes}; such intervals cover about ${knownCoverage(difference.scenes)} %.`;
    const better = difference.value < 0 ? difference.worse : difference.better;
    return ` ${scenes} ${difference.scenes === 1 ? 'is' : 'are'} too few for an interval` +
        (difference.scenes < 2 ? '.' : `; better on ${better} of ${difference.scenes}.`);
}

/// The answer: what stands above, without its full stop, and the sentences below.
function answerWords(view) {
    const {method, mostExact, other, fastest, asCheap} = view.answer;
    const budget = state.get('budget');
    const within = budget ? `Within ${formatMs(budget)} ms, ` : '';
    if (!method && fastest) return [`${within}none has a score: none is faster than ${formatMs(fastest.ms)} ms (${fastest.method})`, ''];
    if (!method) return ['No method has a score here', ''];
    const rival = rivalOf(view);
    const cheaper = rival && rival.line.ms < method.ms ? rival.line : method;
    const words = line => `${line.method}: ${measureWord(view.measure)} ${formatShare(line.value)}${timeText('in', line)}`;
    const first = `${within}${words(method)}${rival ? `, or ${words(rival.line)}` : ''}`;
    const [scene, otherScene] = [method, other].map(line => line && errorSceneText(view, line));
    const note = (rival ? `${(100 * rival.share).toFixed(0)} % of drawings of scenes name the second: ${cheaper.method} is ` +
        `${fixed(mostExact.value - cheaper.value, 4)} below the best, and the margin is ${state.get('margin')}. ` : '') +
        (asCheap.length ? `Times cannot tell it from ${asCheap.map(s => s.method).join(', ')}. ` : '') +
        (scene ? `It has ${scene}. ` : '');
    if (!other) return [`${first}, the only method`, note.trim()];
    const difference = view.differenceOf(other.method, method.method);
    const leads = isLead(difference);
    const isBest = method === mostExact;
    return [first + (isBest ? (rival ? '; the first is the most exact' : ', the most exact') : '') + (method.ms === null ? '; no time was taken' : ''),
        note + (leads && isBest ? 'It leads: ' : '') + `${other.method} ${leads && !isBest ? 'leads with' : 'has'} ` +
        formatShare(other.value) + (otherScene ? ` (${otherScene})` : '') + timeText('at', other) +
        (difference ? ` (${differenceText(difference)}).${intervalSentence(view, difference)}` : '.')];
}

/// The answer as a sentence for a paper.
function paperSentence(view) {
    const {method, mostExact, other} = view.answer;
    const {width, height} = view.run.rows[0];
    const has = line => `has ${measureWord(view.measure)} = ${formatShare(line.value)}`;
    let text = `Over ${scenesText(view, method.scenes)} (${count(method.views, 'view')} of ${width}x${height} px), ` +
        `${method.method} ${has(method)} at ${view.measure === 'f_1px' ? 1 : 2} px${timeText('in', method)}`;
    if (!other) return `${text}.`;
    text += `; ${method === mostExact ? 'the next' : 'the most exact method'}, ${other.method}, ${has(other)}${timeText('in', other)}`;
    if (![method, other].some(line => line.ms === null || line.info.hasOwnClock))
        text += `, ${(other.ms / method.ms).toFixed(1)} times as long`;
    const difference = view.differenceOf(other.method, method.method);
    return text + (difference ? ` (difference ${differenceText(difference)}${difference.range ? ', 95 % interval over scenes' : ''}).` : '.');
}
