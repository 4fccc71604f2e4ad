#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ink::search {

/// What is looked for the lowest value of, over the unit cube.
struct SearchValue {
    double value = 0;
    bool is_new = true;  ///< false where this setting was tried before: it costs no evaluation
};
/// Called with the phase ("start", "global", "local", "random") and a point.
using SearchObjective = std::function<SearchValue(const char*, const std::vector<double>&)>;

/// A derivative-free search in two stages.
struct SearchPlan {
    int evaluations = 300;
    std::uint64_t seed = 0;
    std::string global = "crs";  ///< one of global_searches()
};

/// The names of the searches by which a plan may look globally: crs (controlled random search with
/// local mutation), direct (DIRECT-L, no chance in it).
[[nodiscard]] const std::vector<std::string>& global_searches();

/// Looks first at `start`, then globally for 60 % of the evaluations, then locally from the best
/// point so far, again with other steps where a local search ends early, until the plan's
/// evaluations are used or nothing new turns up. The same plan and values give the same sequence of
/// points. What `objective` throws ends the search and is thrown on.
///
/// Source: NLopt (S. G. Johnson): GN_CRS2_LM after Kaelo and Ali, J. Optim. Theory Appl. 130, 2006;
/// GN_DIRECT_L after Gablonsky and Kelley, J. Global Optim. 21, 2001; LN_SBPLX after Rowan's
/// Subplex, 1990.
void search(const SearchObjective& objective,
            const std::vector<double>& start,
            const SearchPlan& plan);

/// Looks at as many points, even over the cube, chosen at random alone: what every search must
/// beat.
void random_search(const SearchObjective& objective, std::size_t size, const SearchPlan& plan);

}  // namespace ink::search
