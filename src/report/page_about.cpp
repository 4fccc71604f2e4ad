#include "report/page_about.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "core/escape.h"
#include "core/provenance.h"

namespace ink::report {

std::string about_html() {
    return R"html(<p><strong>F</strong> joins precision and recall: F = 2 K / (drawn + true), with K the
largest number of drawn and true pixels that can be paired one to one, at most 2 px (or 1 px) apart. Lines
are thinned first, and 6 px at the frame do not count. The <strong>error</strong> is 1 − F.
<strong>Pooled</strong> values add the counts of all views before they divide; macro is the mean over scenes,
each counting alike, and median takes every view alike. A cell that failed is in none of them.</p>
<p>The <strong>95 % interval</strong> comes from drawing scenes 2000 times, with replacement, each with all its
views, for views of one scene are hard or easy together; with one scene there is none. The bars along the time
axis are quartiles over views. <strong>Truth</strong> is traced from the exact polyhedron as
given. Methods were tuned, if at all, on <strong>training</strong> scenes only; look at the
<strong>held-out</strong> column before you believe a difference.</p>
<p>Three rows are no methods. <strong>none</strong> draws nothing. <strong>oracle</strong> is the stored truth
itself. <strong>sampled</strong> knows the exact lines but sees each pixel once, at its centre: the real
ceiling of every method that does so.</p>
<p><strong>Causes</strong> come from the exact truth at pixel centres. A false pixel is judged by the
3 × 3 pixels round it. For a missing one of a method that declares its code, that code is worked out from
the scene's depth and normals at the stencils that see the line: if it stays silent there, the line is
<em>cancelled</em> where one channel alone would have spoken, else <em>below threshold</em>. The method's picture
is not looked at for either.</p>)html";
}

std::string provenance_html(const ReportData& data) {
    const bool has_own = !data.rows.empty() && data.rows.front().provenance != nullptr;
    const core::Provenance& p = has_own ? *data.rows.front().provenance : core::provenance();
    std::string list;
    const auto add = [&list](std::string_view name, const std::string& value) {
        list += fmt::format("<dt>{}</dt><dd>{}</dd>", core::escape(name), core::escape(value));
    };
    if (!data.command.empty()) {
        list += fmt::format("<dt>command</dt><dd><code>{}</code></dd>", core::escape(data.command));
    }
    add("made", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr))));
    if (data.elapsed_s > 0) add("took", fmt::format("{:.1f} s", data.elapsed_s));
    add("version",
        fmt::format("{}, commit {}{}", p.version, p.commit, p.dirty ? " with changes on top" : ""));
    add("compiler", p.compiler);
    add("flags", p.flags);
    add("processor", p.cpu);
    add("instructions", p.simd);
    std::string libraries;
    for (const auto& [name, version] : p.libraries) {
        libraries += fmt::format("{}{} {}", libraries.empty() ? "" : ", ", name, version);
    }
    add("libraries", libraries);
    return fmt::format("<dl class=\"provenance\">{}</dl>", list);
}

}  // namespace ink::report
