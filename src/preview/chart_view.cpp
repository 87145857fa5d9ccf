#include "preview/chart_view.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "plot/ticks.hpp"

namespace fringe::preview {
namespace {

constexpr ImU32 kPaper = IM_COL32(250, 250, 250, 255), kGrid = IM_COL32(222, 222, 222, 255);
constexpr ImU32 kInk = IM_COL32(40, 40, 40, 255), kFrame = IM_COL32(90, 90, 90, 255);
constexpr ImU32 kCurve = IM_COL32(28, 64, 140, 255), kReference = IM_COL32(222, 115, 20, 255);
constexpr ImU32 kVeil = IM_COL32(250, 250, 250, 200);  // behind labels
constexpr ImU32 kMark = IM_COL32(190, 75, 50, 255);
constexpr double kHeadroom = 1.08;

class Frame {
public:
    Frame(const plot::Chart& chart, ImVec2 origin, ImVec2 size)
        : chart_(chart),
          list_(ImGui::GetWindowDrawList()),
          origin_(origin),
          size_(size),
          text_(ImGui::GetFontSize()) {
        const double highest = plot::highestShown(chart.y, chart.reference.y);
        yMax_ = highest > 0.0 ? kHeadroom * highest : 1.0;
        left_ = origin.x + 4.6F * text_;
        right_ = origin.x + size.x - 0.8F * text_;
        top_ = origin.y + 1.9F * text_;
        bottom_ = origin.y + size.y - (chart.strip.empty() ? 2.6F : 3.6F) * text_;
    }

    void draw() const {
        list_->AddRectFilled(origin_, {origin_.x + size_.x, origin_.y + size_.y}, kPaper, 3.0F);
        grid();
        list_->PushClipRect({left_, top_}, {right_, bottom_}, true);
        if (!chart_.reference.y.empty()) curve(chart_.reference.y, kReference, 2.5F);
        curve(chart_.y, kCurve, 1.4F);
        list_->PopClipRect();
        list_->AddRect({left_, top_}, {right_, bottom_}, kFrame);
        marks();
        strip();
    }

    // The sample nearest to the mouse, which is shown by a line.
    std::optional<std::size_t> hovered() const {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        if (!ImGui::IsItemHovered() || mouse.x < left_ || mouse.x > right_) return std::nullopt;
        const double x = chart_.x.front() +
                         (chart_.x.back() - chart_.x.front()) * double{(mouse.x - left_) / (right_ - left_)};
        const auto after = std::lower_bound(chart_.x.begin(), chart_.x.end(), x);
        auto i = static_cast<std::size_t>(after - chart_.x.begin());
        i = std::min(i, chart_.x.size() - 1);
        if (i > 0 && x - chart_.x[i - 1] < chart_.x[i] - x) --i;
        list_->AddLine({toX(chart_.x[i]), top_}, {toX(chart_.x[i]), bottom_}, kFrame);
        list_->AddCircleFilled({toX(chart_.x[i]), toY(chart_.y[i])}, 0.25F * text_, kCurve);
        return i;
    }

private:
    float toX(double x) const {
        const double share = (x - chart_.x.front()) / (chart_.x.back() - chart_.x.front());
        return left_ + static_cast<float>(share) * (right_ - left_);
    }
    float toY(double y) const { return bottom_ - static_cast<float>(y / yMax_) * (bottom_ - top_); }

    void text(float x, float y, float anchor, const std::string& words, ImU32 color = kInk) const {
        const ImVec2 size = ImGui::CalcTextSize(words.c_str());
        list_->AddText({std::round(x - anchor * size.x), std::round(y)}, color, words.c_str());
    }

    void grid() const {
        const auto columns = static_cast<int>((right_ - left_) / (5.0F * text_));
        const plot::Ticks across =
            plot::ticksBetween(chart_.x.front(), chart_.x.back(), std::max(columns, 2));
        for (const double x : across.values) {
            list_->AddLine({toX(x), top_}, {toX(x), bottom_}, kGrid);
            text(toX(x), bottom_ + 0.2F * text_, 0.5F, across.label(x));
        }
        const plot::Ticks up = plot::ticksBetween(0.0, yMax_, 5);
        for (const double y : up.values) {
            list_->AddLine({left_, toY(y)}, {right_, toY(y)}, kGrid);
            text(left_ - 0.4F * text_, toY(y) - 0.5F * text_, 1.0F, up.label(y));
        }
        text(0.5F * (left_ + right_), bottom_ + 1.3F * text_, 0.5F, chart_.xLabel);
        text(left_, origin_.y + 0.4F * text_, 0.0F, chart_.yLabel);
    }

    // Of more samples than pixels, the least and the greatest in each.
    void curve(std::span<const double> y, ImU32 color, float thickness) const {
        std::vector<ImVec2> points;
        const auto columns = static_cast<std::size_t>(std::max(1.0F, right_ - left_));
        if (y.size() <= 2 * columns) {
            for (std::size_t i = 0; i < y.size(); ++i) points.push_back({toX(chart_.x[i]), toY(y[i])});
        } else {
            for (std::size_t column = 0; column < columns; ++column) {
                const std::size_t first = column * y.size() / columns,
                                  last = (column + 1) * y.size() / columns;
                const auto [low, high] = std::minmax_element(y.begin() + static_cast<std::ptrdiff_t>(first),
                                                             y.begin() + static_cast<std::ptrdiff_t>(last));
                // In the order of the curve: lines that turn back on themselves vanish.
                points.push_back({toX(chart_.x[first]), toY(low < high ? *low : *high)});
                points.push_back({toX(chart_.x[first]), toY(low < high ? *high : *low)});
            }
        }
        list_->AddPolyline(points.data(), static_cast<int>(points.size()), color, ImDrawFlags_None,
                           thickness);
    }

    // A short line over each maximum; labels of the highest first, as long as they do not touch.
    void marks() const {
        std::vector<const plot::Mark*> highestFirst;
        for (const plot::Mark& mark : chart_.marks) highestFirst.push_back(&mark);
        std::stable_sort(highestFirst.begin(), highestFirst.end(),
                         [](const auto* a, const auto* b) { return a->y > b->y; });
        struct Box {
            float left, right, top, bottom;
        };
        std::vector<Box> taken;
        for (const plot::Mark* mark : highestFirst) {
            const ImVec2 size = ImGui::CalcTextSize(mark->label.c_str());
            const float x = toX(mark->x), y = std::max(toY(mark->y), top_ + 1.3F * text_);
            const float left =
                std::clamp(x - 0.5F * size.x, left_ + 2.0F, std::max(left_ + 2.0F, right_ - size.x - 2.0F));
            const Box box{left - 4.0F, left + size.x + 4.0F, y - 1.3F * text_, y - 0.2F * text_};
            list_->AddLine({x, y - 0.2F * text_}, {x, y}, kMark);
            if (std::any_of(taken.begin(), taken.end(), [&](const Box& other) {
                    return box.left < other.right && box.right > other.left && box.top < other.bottom &&
                           box.bottom > other.top;
                }))
                continue;
            taken.push_back(box);
            list_->AddRectFilled({box.left, box.top}, {box.right, box.bottom}, kVeil);
            text(left, box.top, 0.0F, mark->label, kMark);
        }
    }

    void strip() const {
        const std::size_t count = chart_.strip.size();
        const float top = origin_.y + size_.y - 1.1F * text_, bottom = origin_.y + size_.y - 0.4F * text_;
        const auto columns = static_cast<std::size_t>(std::max(1.0F, right_ - left_));
        for (std::size_t column = 0; column < columns && count > 0; ++column) {
            const plot::Color& c = chart_.strip[column * count / columns];
            const float x = left_ + static_cast<float>(column);
            list_->AddRectFilled({x, top}, {x + 1.0F, bottom}, IM_COL32(c[0], c[1], c[2], 255));
        }
    }

    const plot::Chart& chart_;
    ImDrawList* list_;
    ImVec2 origin_, size_;
    float text_;
    float left_, right_, top_, bottom_;
    double yMax_;
};

}  // namespace

std::optional<std::size_t> drawChart(const plot::Chart& chart, float width, float height) {
    const Frame view(chart, ImGui::GetCursorScreenPos(), {width, height});
    ImGui::Dummy({width, height});
    view.draw();
    return view.hovered();
}

}  // namespace fringe::preview
