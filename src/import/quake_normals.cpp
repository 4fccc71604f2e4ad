#include "import/quake_normals.h"

#include <array>
#include <cassert>
#include <string_view>

namespace ink::import {
namespace {

// The corners of an icosahedron whose edges are cut in four and pushed out to the unit sphere, in
// id Software's order. Their coordinates have only so many sizes: a letter each, a capital for less
// than 0.
constexpr std::array kSizes{0.0F,      0.147621F, 0.162460F, 0.238856F, 0.262866F, 0.295242F,
                            0.309017F, 0.425325F, 0.442863F, 0.5F,      0.525731F, 0.587785F,
                            0.681718F, 0.688191F, 0.716567F, 0.809017F, 0.850651F, 0.864188F,
                            0.951056F, 0.955423F, 1.0F};
constexpr std::string_view kLetters =
    "KaqIdrFatGjpCesaauaqkBombomakqgjpkaqfatidrcesMboPgjLhnQkaRidOmbNlhJpgDriHnlOmBJpG"
    "KqaaqKDrIatFEsCauaatfEscdriescjpgdrIesCjpGqkaombomBkqahnlridnlhpgjmbolhntfauaasce"
    "qKatFarIdsCepGjmBoqakriDpgJscEkaQmbOmBOqaKpGJrIDsCEboMgjPhnLidRlhNnlHBoMGjPakQKaQ"
    "IdRFaTCeSaaUfaTceSIDRGJPCESaQKBOMbOMaKQgJPiDRcESdRIjPGhNLoMBnLHlHNaTFaUaeSCaQkaTf"
    "dRieScjPgoMbkQaDRIJPGESCQKaOMBOMbKQaJPgDRiEScRIdPGjNLhMBoIDrLHnGJpBOmHNlCEsiDrcEs"
    "gJpbOmaKqhNllHnnLhTfaSceUaaQakTFaSCeRiDScEPgJRIDSCEPGJMbOMBOQaKNlHLhNHnLHNLLHNNLH";
static_assert(kLetters.size() == 3 * kQuakeNormals);

float coordinate(char letter) {
    const bool is_negative = letter < 'a';
    const float size = kSizes[static_cast<std::size_t>(letter - (is_negative ? 'A' : 'a'))];
    return is_negative ? -size : size;
}

}  // namespace

glm::vec3 quake_normal(std::size_t index) {
    assert(index < kQuakeNormals);
    const std::size_t at = 3 * index;
    return {coordinate(kLetters[at]), coordinate(kLetters[at + 1]), coordinate(kLetters[at + 2])};
}

}  // namespace ink::import
