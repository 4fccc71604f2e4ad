#include "search/search.h"

#include <nlopt.h>
#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <memory>
#include <random>

namespace ink::search {
namespace {

/// Settings are rounded, so a search may ask for one again and again: at most so many questions for
/// each evaluation.
constexpr int kMostCallsPerEvaluation = 20;
/// First steps of the local searches, shares of a parameter's range; one that ends early is
/// followed by the next.
constexpr std::array kLocalSteps = {0.1, 0.03, 0.2, 0.01, 0.05, 0.15};

constexpr double kGlobalShare = 0.6;  // of the evaluations

/// One search: counts what it asks, and knows the best that it saw.
class Searcher {
  public:
    Searcher(const SearchObjective& objective, std::vector<double> start, const SearchPlan& plan)
        : objective_(objective), plan_(plan), best_(std::move(start)) {}

    [[nodiscard]] int evaluations() const { return evaluations_; }

    double look(const char* phase, const std::vector<double>& point) {
        ++calls_;
        const SearchValue found = objective_(phase, point);
        evaluations_ += found.is_new ? 1 : 0;
        if (found.value < best_value_) {
            best_value_ = found.value;
            best_ = point;
        }
        return found.value;
    }

    /// Until `limit` evaluations are used, or the search ends by itself.
    void run(const char* phase, nlopt_algorithm algorithm, double step, int limit) {
        const auto n = static_cast<unsigned>(best_.size());
        const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> opt(nlopt_create(algorithm, n),
                                                                         nlopt_destroy);
        Call call{*this, opt.get(), phase, limit};
        nlopt_set_lower_bounds1(opt.get(), 0);
        nlopt_set_upper_bounds1(opt.get(), 1);
        nlopt_set_xtol_abs1(opt.get(), 1e-4);
        nlopt_set_initial_step1(opt.get(), step);
        nlopt_set_min_objective(opt.get(), &Searcher::answer, &call);
        // The generator is NLopt's one and only: seeded anew for each search.
        nlopt_srand(static_cast<unsigned long>((plan_.seed ^ (plan_.seed >> 32)) & 0xffffffff));
        std::vector<double> point = best_;
        double value = 0;
        // However it ends: what was found is known here.
        (void)nlopt_optimize(opt.get(), point.data(), &value);
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    struct Call {
        Searcher& searcher;
        nlopt_opt opt;
        const char* phase;
        int limit;
    };

    /// NLopt is C and lets no exception through; it is kept, and thrown on by run().
    static double answer(unsigned n, const double* x, double* /*gradient*/, void* data) {
        const Call& call = *static_cast<const Call*>(data);
        Searcher& self = call.searcher;
        const bool is_over = self.failure_ || self.evaluations_ >= call.limit ||
                             self.calls_ >= kMostCallsPerEvaluation * self.plan_.evaluations;
        if (is_over) {
            nlopt_force_stop(call.opt);
            return self.best_value_;
        }
        try {
            return self.look(call.phase, std::vector<double>(x, x + n));
        } catch (...) {
            self.failure_ = std::current_exception();
            nlopt_force_stop(call.opt);
            return self.best_value_;
        }
    }

    const SearchObjective& objective_;
    const SearchPlan& plan_;
    std::vector<double> best_;
    double best_value_ = std::numeric_limits<double>::infinity();
    int evaluations_ = 0;
    int calls_ = 0;
    std::exception_ptr failure_;
};

}  // namespace

const std::vector<std::string>& global_searches() {
    static const std::vector<std::string> names = {"crs", "direct"};
    return names;
}

void search(const SearchObjective& objective,
            const std::vector<double>& start,
            const SearchPlan& plan) {
    Searcher searcher(objective, start, plan);
    searcher.look("start", start);
    const nlopt_algorithm global = plan.global == "direct" ? NLOPT_GN_DIRECT_L : NLOPT_GN_CRS2_LM;
    searcher.run("global", global, 0.25, static_cast<int>(kGlobalShare * plan.evaluations));
    for (const double step : kLocalSteps) {
        if (searcher.evaluations() >= plan.evaluations) break;
        searcher.run("local", NLOPT_LN_SBPLX, step, plan.evaluations);
    }
}

void random_search(const SearchObjective& objective, std::size_t size, const SearchPlan& plan) {
    // The engine's sequence is fixed by the standard; its distributions are not.
    std::mt19937_64 random(plan.seed);
    std::vector<double> point(size);
    int evaluations = 0;
    for (int call = 0; call < kMostCallsPerEvaluation * plan.evaluations; ++call) {
        if (evaluations >= plan.evaluations) break;
        for (double& x : point)
            x = static_cast<double>(random() >> 11) * 0x1p-53;
        evaluations += objective("random", point).is_new ? 1 : 0;
    }
}

}  // namespace ink::search
