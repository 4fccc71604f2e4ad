// The answer: which method, and what it is held against. The rule and the words are those of the
// program (src/summary/answer.cpp, src/report/text/answer_text.cpp), of what the filters leave; a test
// holds the sentences against verdict.md.

/// F is .01 below another where rounding leaves a little more.
const F_ROUNDING = 1e-9;

/// Of the methods within the budget the cheapest by the program's clock whose value is at most the
/// margin below the best of them; the most exact itself where none such was timed.
function findAnswer(contestants, {margin, budget}) {
    const isCheaper = (a, b) => a.ms < b.ms || (a.ms === b.ms && a.value > b.value);
    const cheapest = lines => lines.reduce((a, b) => (a && !isCheaper(b, a) ? a : b), null);
    const best = lines => lines.reduce((a, b) => (a && !(b.value > a.value) ? a : b), null);
    const within = contestants.filter(s => !budget || (s.ms !== null && s.ms <= budget));
    const mostExact = best(within);
    const asGood = within.filter(s => s.ms !== null && !s.info.hasOwnClock && mostExact.value - s.value <= margin + F_ROUNDING);
    const method = cheapest(asGood) || mostExact;
    const next = best(within.filter(s => s !== mostExact));
    return {method, mostExact, next, fastest: cheapest(contestants.filter(s => s.ms !== null)), other: method === mostExact ? next : mostExact};
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
    const {method, mostExact, other, fastest} = view.answer;
    const budget = state.get('budget');
    const within = budget ? `Within ${formatMs(budget)} ms, ` : '';
    if (!method && fastest) return [`${within}none has a score: none is faster than ${formatMs(fastest.ms)} ms (${fastest.method})`, ''];
    if (!method) return ['No method has a score here', ''];
    const first = `${within}${method.method}: ${measureWord(view.measure)} ${formatShare(method.value)}${timeText('in', method)}`;
    const [scene, otherScene] = [method, other].map(line => line && errorSceneText(view, line));
    const note = scene ? `It has ${scene}. ` : '';
    if (!other) return [`${first}, the only method`, note.trim()];
    const difference = view.differenceOf(other.method, method.method);
    const leads = isLead(difference);
    const isBest = method === mostExact;
    return [first + (isBest ? ', the most exact' : '') + (method.ms === null ? '; no time was taken' : ''),
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
