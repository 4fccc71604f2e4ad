#include "inspect/explain.h"

#include <gtest/gtest.h>

#include "harness/suite/suite.h"
#include "methods/method_configs.h"

namespace ink::inspect {
namespace {

TEST(Explain, TextHasAHeadingForEachPart) {
    const Explanation torus =
        explain(harness::load_scene("torus"), methods::make_configs("auto", {}).front(), 40);
    ASSERT_FALSE(torus.plan.empty());
    const std::string text = as_text(torus);
    for (const std::string& part : {std::string("torus: its scene statistics"),
                                    std::string("auto: what it chose, and why"),
                                    torus.plan.front().why})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace ink::inspect
