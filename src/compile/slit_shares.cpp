#include "compile/slit_shares.hpp"

#include <algorithm>
#include <cmath>

#include "compile/parallel.hpp"
#include "compile/table_memo.hpp"

namespace fringe::compile {
namespace {

// Of drafts: the share of more slits differs by 1e-3 and less, and so do straight lines between.
constexpr std::uint32_t kDraftSlits = 256;
constexpr double kDraftWaveStep_nm = 8.0;

std::vector<double> makeShares(LitSlits lit, double step_nm, bool isDraft) {
    const auto last =
        static_cast<int>(std::lround((optics::kLongestVisible_nm - optics::kShortestVisible_nm) / step_nm));
    const int stride = isDraft ? std::max(1, static_cast<int>(kDraftWaveStep_nm / step_nm)) : 1;
    if (isDraft) lit.slits.count = std::min(lit.slits.count, kDraftSlits);
    std::vector<double> shares(static_cast<std::size_t>(last) + 1);
    const auto at = [&](int i) -> double& { return shares[static_cast<std::size_t>(i)]; };
    inParallel((last + stride - 1) / stride + 1, [&](int node) {
        const int i = std::min(node * stride, last);
        at(i) = lit.propagatingShare(optics::kShortestVisible_nm + i * step_nm);
    });
    for (int left = 0; left < last; left += stride) {
        const int right = std::min(left + stride, last);
        for (int i = left + 1; i < right; ++i)
            at(i) = std::lerp(at(left), at(right), 1.0 * (i - left) / (right - left));
    }
    return shares;
}

}  // namespace

std::shared_ptr<const std::vector<double>> propagatingShares(const LitSlits& lit, double step_nm,
                                                             TableMemo* memo) {
    TableMemo::Key key;
    key.add(optics::Aperture(lit.slits)).add(lit.alphaIn).add(lit.betaIn).add(step_nm);
    key.add(lit.orders.empty() ? 1.0 : 0.0);
    return rememberedOrDraft(memo, std::move(key),
                             [&](bool isDraft) { return makeShares(lit, step_nm, isDraft); });
}

}  // namespace fringe::compile
