#pragma once

#include "edge/edge_image.h"
#include "truth/eye_view.h"

namespace ink::truth {

/// One exact sample a pixel, at its centre: the exact classes seen through ids at pixel centres,
/// 255 where a line runs between two pixels that are neighbours, else 0. A check on construction A,
/// whose visibility it does not use. No ceiling: a method may draw lines wider than a pixel and so
/// join the dots of a bar thinner than one, or mark by luck what no sample sees.
///
/// Where the faces at two neighbouring centres (left and right, or above and below) differ, the
/// rule walks over the mesh along the segment between them, from the one face towards the other
/// centre and from the other back, until it reaches the other face (there is no line) or crosses a
/// feature edge. That is a line if the edge's surface is not behind the surface of the other walk
/// at that point; of two lines the nearer counts, of equally near ones the first. Against the sky
/// there is one walk. A face within 1e-3 px of its centre counts as met there. Where the surface of
/// one walk, until then the nearer, goes under that of the other, the two pierce each other: that
/// is a line too, found from the depths along both walks and not from the crossings of the model.
/// Where the ids differ (smooth patches, of one object or two) and no such line is found, the pixel
/// is marked that method `ids` marks: something lies between that neither centre hits, or the
/// patches meet without sharing vertices. Over a crack of less than 1/64 px, and between faces that
/// coincide, ids do not differ.
///
/// The line is drawn at that of the two pixels which holds the crossing, as the truth image draws
/// it. At the pixel of the nearer surface it would be as near, but where lines run two pixels apart
/// thinning then merges other ones than in the truth: F .944 instead of .993 on a flag
/// beside its pole, of .957 instead of .978 on temple.glb.
///
/// `face` holds at each pixel centre the index of the seen face in the topology, or kNoFace.
[[nodiscard]] edge::EdgeImage draw_sampled(const EyeView& eye,
                                           const core::Image<std::uint32_t>& face,
                                           int threads);

/// One exact sample a pixel, at its corner: a pixel is a line, 255, if on one of its four sides the
/// surface seen at the one corner does not go on to the other, by the rule of draw_sampled; else 0.
///
/// What lies between two corners is known exactly where either corner's surface tells of it, and
/// else not at all: of a bar thinner than a pixel, whose both lines pass between two corners,
/// nothing is seen there. Where a line runs within its pixel need not be asked: it is the pixel
/// that the truth image marks, too. No ceiling either, for the same reasons.
///
/// `face` holds the index of the seen face, or kNoFace, at each pixel corner: one row and one
/// column more than the image, (x, y) the upper left corner of pixel (x, y).
[[nodiscard]] edge::EdgeImage draw_exact_corner(const EyeView& eye,
                                                const core::Image<std::uint32_t>& face,
                                                int threads);

}  // namespace ink::truth
