#pragma once
// Purpose: the little SVG that pictures of the experiment need: axes with round ticks, lines, marks, text. Lengths are pixels, y
// downwards.

#include <string>
#include <string_view>
#include <vector>

namespace glisson::lab {

/// For text and attributes of HTML and SVG: & < > " ' as entities, control characters as blanks.
std::string escaped(std::string_view text);

/// Maps values to pixels, linearly or by their logarithm.
class Axis {
 public:
  /// `low` < `high`, both above 0 where `logarithmic`; pixels `from` at low, `to` at high.
  Axis(double low, double high, double from, double to, bool logarithmic = false);
  [[nodiscard]] double at(double value) const;
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }
  /// Round values within the range: 1, 2 or 5 times a power of ten, about `wanted` of them.
  [[nodiscard]] std::vector<double> ticks(int wanted) const;

 private:
  double low_;
  double high_;
  double from_;
  double to_;
  bool logarithmic_;
};

struct Pixel {
  double x = 0;
  double y = 0;
};

/// Pictures of the experiment are as wide as one another, and so are their margins.
inline constexpr double kPlotWidth = 920;
inline constexpr double kPlotLeft = 64;
inline constexpr double kPlotRight = kPlotWidth - 16;

/// A picture to stand in an HTML page that has plotSheet().
std::string svgPicture(double width, double height, std::string_view title, const std::string& content);
/// A file of its own: with its style sheet and a white ground. `picture` is what svgPicture() gives.
std::string svgFile(const std::string& picture);
/// CSS of all the classes that pictures use.
std::string_view plotSheet();

/// Elements; `style` is a class of the sheet.
std::string svgLine(const Pixel& from, const Pixel& to, std::string_view style);
std::string svgPath(const std::vector<Pixel>& corners, std::string_view style);
std::string svgRectangle(const Pixel& corner, double width, double height, std::string_view style);
/// `anchor` is start, middle or end. `text` is escaped here.
std::string svgText(const Pixel& at, std::string_view text, std::string_view anchor, std::string_view style);

enum class Mark : std::uint8_t { Circle, Diamond, Triangle, Square };
/// With a tooltip, escaped here.
std::string svgMark(Mark mark, const Pixel& at, double radius, std::string_view style, std::string_view tooltip);

/// The line across a plot at `y`, with its value on the left.
std::string svgGridLine(double y, double value);

/// Whole numbers with thin blanks between thousands, others with as many digits as they need: "88 592", "0.25".
std::string tickText(double value);

}  // namespace glisson::lab
