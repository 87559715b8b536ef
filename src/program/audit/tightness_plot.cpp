// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tightness_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

namespace corral::program {

namespace {

// Positions in the drawing, in its own units.
constexpr double width = 500;
constexpr double height = 340;
constexpr double left = 62;
constexpr double right = 14;
constexpr double top = 12;
constexpr double bottom = 52;

constexpr double least_excess = 1e-6; // the exact range is known no better

std::string number(double value)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1f", value);
  return buffer;
}

// Colours that also people with a colour deficiency tell apart, one for each bounder; orders differ by their dashes.
std::string style(const std::vector<const Method_audit*>& audits, const Method_audit& audit)
{
  static constexpr const char* colours[] = {"#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                            "#e69f00", "#56b4e9", "#8c564b", "#7f7f7f", "#5e3c99"};
  static constexpr const char* dashes[] = {"1 3", "", "7 3", "2 4 8 4"};
  std::vector<std::string> bounders;
  for (const auto* const other : audits)
    if (std::find(bounders.begin(), bounders.end(), other->method.bounder) == bounders.end())
      bounders.push_back(other->method.bounder);
  const auto place = std::find(bounders.begin(), bounders.end(), audit.method.bounder) - bounders.begin();
  std::string result = "stroke=\"";
  result += colours[static_cast<std::size_t>(place) % std::size(colours)];
  result += "\"";
  const std::string dash = audit.has_order ? dashes[(audit.method.order - 1) % std::size(dashes)] : "";
  if (!dash.empty()) result += " stroke-dasharray=\"" + dash + "\"";
  return result;
}

// The median excess at each place of the axis.
std::map<double, double> medians(const Method_audit& audit, Plot_axis axis)
{
  std::map<double, std::vector<double>> groups;
  for (const auto& sample : audit.tightness)
    groups[axis == Plot_axis::degree ? sample.degree : std::log2(sample.box_width)].push_back(sample.ratio - 1);
  std::map<double, double> result;
  for (auto& [place, excesses] : groups) {
    const auto middle = excesses.begin() + static_cast<std::ptrdiff_t>(excesses.size() / 2);
    std::nth_element(excesses.begin(), middle, excesses.end());
    if (std::isfinite(*middle)) result[place] = std::max(*middle, least_excess);
  }
  return result;
}

/// The two scales and the drawing so far.
class Plot
{
public:
  Plot(Plot_axis axis, double low_x, double high_x, double high_decade)
      : low_x_(low_x), span_x_(std::max(high_x - low_x, 1.0)), high_decade_(high_decade)
  {
    svg_ = "<svg viewBox=\"0 0 " + number(width) + ' ' + number(height) + "\" width=\"" + number(width) + "\" height=\""
           + number(height) + "\" fill=\"none\" role=\"img\">\n";
    for (double decade = low_decade; decade <= high_decade_; ++decade) {
      const std::string y_text = number(y(decade));
      svg_ += "<path stroke=\"#e4e4e4\" d=\"M" + number(left) + ' ' + y_text + "H" + number(width - right) + "\"/>\n";
      if (static_cast<int>(decade) % 2 == 0)
        text(left - 8, y(decade) + 4, "end", power_label("10", static_cast<int>(decade)));
    }
    const double step = axis == Plot_axis::degree ? (span_x_ > 8 ? 2 : 1) : 2;
    for (double place = std::ceil(low_x); place <= high_x; place += step)
      text(x(place), height - bottom + 19, "middle",
           axis == Plot_axis::degree ? number_label(place) : power_label("2", static_cast<int>(place)));
    svg_ += "<path stroke=\"#555\" d=\"M" + number(left) + ' ' + number(top) + "V" + number(height - bottom) + "H"
            + number(width - right) + "\"/>\n";
    text((left + width - right) / 2, height - 8, "middle",
         axis == Plot_axis::degree ? "total degree" : "width of the box");
  }

  void line(const std::map<double, double>& points, const std::string& style)
  {
    std::string data;
    for (const auto& [place, excess] : points)
      data.append(data.empty() ? "M" : "L").append(number(x(place))).append(" ").append(number(y(std::log10(excess))));
    svg_ += "<path stroke-width=\"1.8\" stroke-linejoin=\"round\" " + style + " d=\"" + data + "\"/>\n";
  }

  [[nodiscard]] std::string finished() && { return std::move(svg_) + "</svg>\n"; }

private:
  static constexpr double low_decade = -6;

  [[nodiscard]] double x(double place) const { return left + (place - low_x_) / span_x_ * (width - left - right); }
  [[nodiscard]] double y(double decade) const
  {
    return height - bottom - (decade - low_decade) / (high_decade_ - low_decade) * (height - top - bottom);
  }
  static std::string number_label(double value) { return std::to_string(static_cast<int>(value)); }
  static std::string power_label(std::string base, int exponent)
  {
    base += "<tspan dy=\"-5\" font-size=\"10\">";
    if (exponent < 0) base += "&#8722;";
    return base.append(std::to_string(std::abs(exponent))).append("</tspan>");
  }
  void text(double at_x, double at_y, const char* anchor, const std::string& what)
  {
    svg_ += "<text fill=\"#333\" text-anchor=\"" + std::string(anchor) + "\" x=\"" + number(at_x) + "\" y=\""
            + number(at_y) + "\">" + what + "</text>\n";
  }

  double low_x_;
  double span_x_;
  double high_decade_;
  std::string svg_;
};

} // namespace

std::string tightness_plot(const std::vector<const Method_audit*>& audits, Plot_axis axis)
{
  std::vector<std::map<double, double>> lines;
  double low_x = HUGE_VAL;
  double high_x = -HUGE_VAL;
  double high_decade = 0;
  for (const auto* const audit : audits) {
    lines.push_back(medians(*audit, axis));
    for (const auto& [place, excess] : lines.back()) {
      low_x = std::min(low_x, place);
      high_x = std::max(high_x, place);
      high_decade = std::max(high_decade, std::ceil(std::log10(excess)));
    }
  }
  if (low_x > high_x) return {};
  Plot plot(axis, low_x, high_x, high_decade);
  for (std::size_t k = 0; k < audits.size(); ++k) plot.line(lines[k], style(audits, *audits[k]));
  return std::move(plot).finished();
}

std::string plot_legend(const std::vector<const Method_audit*>& audits)
{
  std::string html = "<p class=\"legend\">";
  for (const auto* const audit : audits)
    html += "<span><svg width=\"34\" height=\"8\" fill=\"none\"><path stroke-width=\"2\" " + style(audits, *audit)
            + " d=\"M0 4H34\"/></svg> " + audit->bounder_name() + "</span>\n";
  return html + "</p>\n";
}

} // namespace corral::program
