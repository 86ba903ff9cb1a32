#include "app/lab/svg.h"

#include <algorithm>
#include <cmath>

#include "reconstruction/text.h"

namespace glisson::lab {

namespace {

std::string pixels(double value) { return formatNumber(value, 1); }

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string pathOf(const std::vector<Pixel>& corners) {
  std::string path;
  for (const Pixel& corner : corners) {
    path += (path.empty() ? "M" : "L") + pixels(corner.x) + " " + pixels(corner.y);
  }
  return path;
}

constexpr std::string_view kPlotSheet = R"(
svg text { font: 12px system-ui, "Segoe UI", "DejaVu Sans", sans-serif; fill: #1d2733; }
svg .tick { fill: #1d2733; } svg .faint { fill: #5d6b7a; } svg .axis { fill: #5d6b7a; }
svg .grid { stroke: #dfe4ea; } svg .label { font-weight: 600; paint-order: stroke; stroke: #fff; stroke-width: 4px; }
svg .leader { stroke: #5d6b7a; } svg .ring { fill: none; stroke: #1d2733; stroke-width: 1.5; }
svg .psr { fill: #c2361c; } svg .mcsd { fill: #3f74b5; fill-opacity: .75; } svg .simplified { fill: #1d8348; }
svg .other { fill: #7d3c98; } svg .patient { fill: none; stroke: #dfe4ea; stroke-width: 2; }
svg .front { fill: none; stroke: #1d2733; stroke-width: 1.5; }
svg .front2 { fill: none; stroke: #1d8348; stroke-width: 1.5; stroke-dasharray: 6 4; }
svg .box { fill-opacity: .35; stroke: #1d2733; } svg .whisker { stroke: #1d2733; } svg .median { stroke: #1d2733; stroke-width: 2.5; }
)";

}  // namespace

std::string_view plotSheet() { return kPlotSheet; }

std::string svgPicture(double width, double height, std::string_view title, const std::string& content) {
  return "<svg viewBox=\"0 0 " + formatNumber(width, 0) + " " + formatNumber(height, 0) + "\" role=\"img\" aria-label=\"" +
         escaped(title) + "\">\n" + content + "</svg>\n";
}

std::string svgFile(const std::string& picture) {
  const std::size_t rest = std::string_view("<svg").size();
  const std::size_t inside = picture.find('>') + 1;
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
         picture.substr(rest, inside - rest) + "\n<style>" + std::string(kPlotSheet) +
         "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>" + picture.substr(inside);
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return safe;
}

Axis::Axis(double low, double high, double from, double to, bool logarithmic)
    : low_(low), high_(high), from_(from), to_(to), logarithmic_(logarithmic) {}

double Axis::at(double value) const {
  const double share = logarithmic_ ? std::log(value / low_) / std::log(high_ / low_) : (value - low_) / (high_ - low_);
  return from_ + share * (to_ - from_);
}

std::vector<double> Axis::ticks(int wanted) const {
  std::vector<double> values;
  if (logarithmic_) {
    const auto first = static_cast<int>(std::floor(std::log10(low_)));
    const auto last = static_cast<int>(std::floor(std::log10(high_)));
    for (int exponent = first; exponent <= last; ++exponent) {
      const double power = std::pow(10.0, exponent);
      for (const double step : {1.0, 2.0, 5.0}) {
        if (step * power >= low_ && step * power <= high_) {
          values.push_back(step * power);
        }
      }
    }
    return values;
  }
  const double rough = (high_ - low_) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double share = rough / power;
  const double step = power * (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10);
  const auto last = static_cast<long>(std::floor(high_ / step + 1e-9));
  for (auto n = static_cast<long>(std::ceil(low_ / step - 1e-9)); n <= last; ++n) {
    values.push_back(static_cast<double>(n) * step);
  }
  return values;
}

std::string svgLine(const Pixel& from, const Pixel& to, std::string_view style) { return svgPath({from, to}, style); }

std::string svgPath(const std::vector<Pixel>& corners, std::string_view style) {
  return "<path" + attribute("class", style) + attribute("d", pathOf(corners)) + "/>\n";
}

std::string svgRectangle(const Pixel& corner, double width, double height, std::string_view style) {
  return "<rect" + attribute("class", style) + attribute("x", pixels(corner.x)) + attribute("y", pixels(corner.y)) +
         attribute("width", pixels(width)) + attribute("height", pixels(height)) + "/>\n";
}

std::string svgText(const Pixel& at, std::string_view text, std::string_view anchor, std::string_view style) {
  return "<text" + attribute("class", style) + attribute("x", pixels(at.x)) + attribute("y", pixels(at.y)) +
         attribute("text-anchor", anchor) + ">" + escaped(text) + "</text>\n";
}

std::string svgMark(Mark mark, const Pixel& at, double radius, std::string_view style, std::string_view tooltip) {
  const std::string title = tooltip.empty() ? std::string() : "<title>" + escaped(tooltip) + "</title>";
  if (mark == Mark::Circle) {
    return "<circle" + attribute("class", style) + attribute("cx", pixels(at.x)) + attribute("cy", pixels(at.y)) +
           attribute("r", pixels(radius)) + ">" + title + "</circle>\n";
  }
  const double r = 1.25 * radius;
  const double s = 0.7 * r;
  const std::vector<Pixel> corners =
      mark == Mark::Diamond ? std::vector<Pixel>{{at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}}
      : mark == Mark::Square
          ? std::vector<Pixel>{{at.x - s, at.y - s}, {at.x + s, at.y - s}, {at.x + s, at.y + s}, {at.x - s, at.y + s}}
          : std::vector<Pixel>{{at.x, at.y - r}, {at.x + r, at.y + 0.8 * r}, {at.x - r, at.y + 0.8 * r}};
  return "<path" + attribute("class", style) + attribute("d", pathOf(corners) + "Z") + ">" + title + "</path>\n";
}

std::string svgGridLine(double y, double value) {
  return svgLine({kPlotLeft, y}, {kPlotRight, y}, "grid") + svgText({kPlotLeft - 8, y + 4}, tickText(value), "end", "tick");
}

std::string tickText(double value) {
  if (value != std::round(value) || std::abs(value) >= 1e15) {
    return formatExact(std::round(1e6 * value) / 1e6);
  }
  std::string text = std::to_string(static_cast<long long>(value));
  const std::size_t sign = value < 0 ? 1 : 0;
  for (std::size_t n = text.size(); n > sign + 3;) {
    n -= 3;
    text.insert(n, "\u202f");  // a narrow blank that does not break
  }
  return text;
}

}  // namespace glisson::lab
