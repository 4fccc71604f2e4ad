// Which method the counts and times that filters leave point at. What the page says of the whole run
// are the program's own words (src/report/text/answer_text.cpp); a test holds both against each other.

/// F is .01 below another where rounding leaves a little more.
const F_ROUNDING = 1e-9;

/// A method that takes less than this many times as long as the cheapest is as cheap.
const ALIKE_TIMES = 1.3;

/// Of the methods within the budget whose value is at most the margin below the best of them the cheapest
/// by the program's clock; of those whose times are alike, the most exact; of equals one that draws by
/// itself. The most exact itself where none such was timed.
function findAnswer(contestants, {margin, budget}) {
    const isCheaper = (a, b) => a.ms < b.ms || (a.ms === b.ms && a.value > b.value);
    const cheapest = lines => lines.reduce((a, b) => (a && !isCheaper(b, a) ? a : b), null);
    const isChoice = s => s.info.family === 'other';
    const isBefore = (a, b) => a.value > b.value || (a.value === b.value && !isChoice(a) && isChoice(b));
    const best = lines => lines.reduce((a, b) => (a && !isBefore(b, a) ? a : b), null);
    const within = contestants.filter(s => !budget || (s.ms !== null && s.ms <= budget));
    const mostExact = best(within);
    const asGood = within.filter(s => s.ms !== null && !s.info.hasOwnClock && mostExact.value - s.value <= margin + F_ROUNDING);
    const least = cheapest(asGood);
    const method = best(asGood.filter(s => s === least || s.ms < ALIKE_TIMES * least.ms)) || mostExact;
    return {method, mostExact, fastest: cheapest(contestants.filter(s => s.ms !== null))};
}

/// That method with its measure and time, as a heading.
function answerOfSums({answer: {method, fastest}, measure}) {
    const budget = state.get('budget');
    const within = budget ? `Within ${formatMs(budget)} ms, ` : '';
    if (!method) return fastest ? `${within}none has a score: none is faster than ${formatMs(fastest.ms)} ms (${fastest.method})` : 'No method has a score here';
    const time = method.ms === null ? '' : ` in ${formatMs(method.ms)} ms${method.info.hasOwnClock ? ' by its own clock' : ''}`;
    return `${within}${method.method}: ${MEASURES[measure].title} ${formatShare(method.value)}${time}`;
}
