// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How film.hpp draws: places become pixels, faces are sorted and put together, frames become lines of an SVG.

#include "film.hpp"

#include "film_shapes.hpp"
#include "film_tiles.hpp"
#include "gnuplot.hpp" // the folder for pictures

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace ansatz::workbook {

inline Film::Film(std::string number, std::string title, std::string told, const View& view)
    : number_{std::move(number)}, title_{std::move(title)}, told_{std::move(told)}, view_{view}, scenery_{*this, -1} {
    const double width = view.width.value(), height = view.height.value();
    if (!(width > 0) || !(height > 0) || !std::isfinite(width) || !std::isfinite(height))
        refuse("its view is " + film::digits(width) + " m wide and " + film::digits(height) +
               " m high; both are greater than zero");
    scale_ = wide / width;
    tall_ = title_height + int(std::ceil(wide * height / width));
    const double st = sin(view.turn), ct = cos(view.turn), sa = sin(view.above), ca = cos(view.above);
    right_ = {ct, 0, -st};
    up_ = {-st * sa, ca, -ct * sa};
    toward_ = {st * ca, sa, ct * ca};
}

inline Frame& Film::frame(Quantity<unit::Time> time) {
    const double now = time.value();
    if (!std::isfinite(now)) refuse("frame " + std::to_string(frames_.size()) + " is at no time: " + film::digits(now));
    if (frames_.size() > 1) {
        const double first = frames_[1].time_ - frames_[0].time_, next = now - frames_.back().time_;
        if (std::abs(next - first) > 1e-6 * first)
            refuse("frame " + std::to_string(frames_.size()) + " comes " + film::digits(next) +
                   " s after the one before it, and the second came " + film::digits(first) +
                   " s after the first; frames are equally far apart");
    } else if (frames_.size() == 1 && !(now > frames_[0].time_)) refuse("frame 1 is not later than frame 0");
    frames_.push_back(Frame(*this, now));
    return frames_.back();
}

inline void Film::check() const {
    if (frames_.empty()) refuse("it has no frame");
    if (!(rate_ > 0) || !std::isfinite(rate_)) refuse("it plays " + film::digits(rate_) + " frames a second");
    for (std::size_t k = 0; k < frames_.size(); ++k) {
        const auto &now = frames_[k].added_, &first = frames_[0].added_;
        if (now.empty()) frames_[k].refuse("nothing is drawn in it");
        if (may_change_) continue;
        if (now.size() != first.size())
            frames_[k].refuse(std::to_string(now.size()) + " things are drawn, and " + std::to_string(first.size()) +
                              " in frame 0; say may_change() where that is meant");
        for (std::size_t i = 0; i < now.size(); ++i)
            if (now[i] != first[i])
                frames_[k].refuse("thing " + std::to_string(i) + " is a " + now[i].first + " of " +
                                  std::to_string(now[i].second) + " points, and in frame 0 a " + first[i].first +
                                  " of " + std::to_string(first[i].second) + "; say may_change() where that is meant");
    }
}

/// A letter for each paint, in the order in which they are asked for.
inline char Film::letter_of(const Paint& paint) {
    if (paints_.size() == 26 && paints_.find(paint) == paints_.end()) refuse("it has more than 26 paints");
    return paints_.try_emplace(paint, char('a' + paints_.size())).first->second;
}
/// The class of a colour, made when it is first asked for: a letter for the paint, and its kind or its shade, 0 to 7.
inline std::string Film::style_of(const Paint& paint, int shade, bool back, const char* kind) {
    std::string style{letter_of(paint)};
    if (*kind != '\0') style += kind;
    else style += (back ? "_" : "") + std::to_string(shade);
    auto& rule = styles_[style];
    if (!rule.empty()) return style;
    const unsigned colour = back ? paint.back : paint.front;
    if (style.back() == 'l') rule = "fill:none;stroke-width:4;stroke:" + film::shaded(colour, 4);
    else if (style.back() == 'g') rule = "fill:url(#" + style + ");stroke:" + film::shaded(colour, 0);
    else rule = "fill:" + film::shaded(colour, shade) + ";stroke:" + film::shaded(colour, shade - 2);
    if (paint.opacity != 100) rule += ";fill-opacity:" + film::digits(paint.opacity / 100.0);
    return style;
}
/// The class of one row of many; its line is that of the light on it.
inline std::string Film::style_of_row(const Paint& paint, std::size_t j, std::size_t rows) {
    auto style = std::string{letter_of(paint)} + "w" + std::to_string(j);
    styles_[style] = "fill:" + film::hazy(paint.front, j, rows) + ";stroke:#fff;stroke-opacity:.6";
    return style;
}
inline std::string Film::styles() const {
    std::string all;
    for (const auto& [style, rule] : styles_) all += "." + style + "{" + rule + "}\n";
    return all;
}
/// Balls are lit from above, on the left.
inline std::string Film::gradients() const {
    std::string all;
    for (const auto& [paint, letter] : paints_) {
        if (styles_.find(std::string{letter} + "g") == styles_.end()) continue;
        all += std::string{"<radialGradient id=\""} + letter +
               "g\" cx=\".36\" cy=\".3\" r=\".75\"><stop stop-color=\"" + film::shaded(paint.front, 7) +
               "\"/><stop offset=\".5\" stop-color=\"" + film::shaded(paint.front, 4) +
               "\"/><stop offset=\"1\" stop-color=\"" + film::shaded(paint.front, 1) + "\"/></radialGradient>\n";
    }
    return all;
}

inline std::string Film::head(int width, int height, const std::string& rules) const {
    std::ostringstream s;
    s << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
      << "\" width=\"640\" height=\"" << (height * 640 + width / 2) / width
      << "\" role=\"img\" aria-labelledby=\"t d\">\n"
      << "<title id=\"t\">" << film::escaped(title_) << "</title>\n<desc id=\"d\">" << film::escaped(told_)
      << "</desc>\n"
      << "<style>\npath,circle{stroke-width:1.5;stroke-linejoin:round}\n"
      << "text{font:26px 'DejaVu Sans',Verdana,Helvetica,Arial,sans-serif;fill:#222}\n"
      << ".n{text-anchor:end;fill:#555}\n.s{fill:#d3d6d8}\n.e{fill:#eef0f1}\n.r{fill:none;stroke:#dadddf}\n"
      << styles() << rules << "</style>\n";
    if (const auto balls = gradients(); !balls.empty()) s << "<defs>\n" << balls << "</defs>\n";
    s << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    return s.str();
}
/// Its time, on the right, at a height.
inline std::string Film::stamp(const Frame& frame, int height) const {
    const double apart = frames_.size() > 1 ? frames_[1].time_ - frames_[0].time_ : 1;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), apart < 0.0999 ? "%.2f s" : "%.1f s", frame.time_ + 1e-9);
    const auto said =
        counted_.empty() ? text.data() : film::digits(std::round(frame.time_)) + ' ' + film::escaped(counted_);
    return "<text class=\"n\" x=\"" + std::to_string(wide - 20) + "\" y=\"" + std::to_string(height) + "\">" + said +
           "</text>";
}

inline std::string Film::text() const {
    check();
    const std::size_t count = frames_.size() + hold_, still = std::min(still_, frames_.size() - 1);
    const std::size_t shown = still_ == std::size_t(-1) ? frames_.size() / 2 : still;
    const double length = double(count) / rate_;
    // Each frame is seen for its part of the film and hidden for the rest; it began so long ago that its turn comes. It
    // stays a fiftieth of a frame longer, under the next one, which hides it: at the moment between two there is
    // neither none nor a ghost of both.
    const auto keyframes = [&](const char* of, std::size_t frames) {
        return std::string{"@keyframes "} + of + "{0%{visibility:visible}" +
               film::digits(100 * (double(frames) + 0.02) / double(count)) + "%,to{visibility:hidden}}\n";
    };
    std::ostringstream s;
    s << head(wide, tall(),
              ".f{visibility:hidden;animation:f " + film::digits(length) +
                  "s step-end infinite}\n.l{animation-name:l}\n" + ".still{visibility:visible}\n" + keyframes("f", 1) +
                  keyframes("l", 1 + hold_) + "@media (prefers-reduced-motion:reduce),print{.f{animation:none}}\n" +
                  "svg:hover .f{animation-play-state:paused}\n")
      << "<g id=\"scene\"><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/><text x=\"20\" y=\"42\">"
      << film::escaped(title_) << "</text>" << scenery_.drawn() << "</g>\n";
    for (std::size_t k = 0; k < frames_.size(); ++k)
        s << "<g id=\"f" << k << "\" class=\"f" << (k == shown ? " still" : "") << (k + 1 == frames_.size() ? " l" : "")
          << "\" style=\"animation-delay:" << film::digits(-double(count - k) / rate_) << "s\"><use href=\"#scene\"/>"
          << frames_[k].drawn() << stamp(frames_[k], 42) << "</g>\n";
    s << "</svg>\n";
    return s.str();
}

inline std::string Film::sheet(std::size_t pictures) const {
    check();
    if (pictures < 1) refuse("its sheet has no picture");
    pictures = std::min(pictures, frames_.size());
    const int across = std::min(3, int(pictures)), down = (int(pictures) + across - 1) / across, gap = 20;
    const int height = title_height + down * (tall() - title_height + gap);
    std::ostringstream s;
    s << head(across * (wide + gap) - gap, height, "") << "<text x=\"20\" y=\"42\">" << film::escaped(title_)
      << "</text>\n";
    const int seen = tall() - title_height;
    for (std::size_t i = 0; i < pictures; ++i) {
        const auto k = pictures == 1 ? 0 : i * (frames_.size() - 1) / (pictures - 1);
        s << "<svg x=\"" << int(i) % across * (wide + gap) << "\" y=\"" << title_height + int(i) / across * (seen + gap)
          << "\" width=\"" << wide << "\" height=\"" << seen << "\" viewBox=\"0 " << title_height << ' ' << wide << ' '
          << seen << "\">";
        if (i == 0) s << "<g id=\"scene\">" << scenery_.drawn() << "</g>";
        else s << "<use href=\"#scene\"/>";
        s << "<g id=\"f" << k << "\">" << frames_[k].drawn() << stamp(frames_[k], title_height + 34) << "</g><rect y=\""
          << title_height << "\" width=\"" << wide << "\" height=\"" << seen
          << "\" fill=\"none\" stroke=\"#bbb\" stroke-width=\"3\"/></svg>\n";
    }
    s << "</svg>\n";
    return s.str();
}

inline std::string Film::name(const char* what) const { return number_ + "-" + what + ".svg"; }

inline bool Film::write(std::size_t pictures_of_sheet) const {
    const std::array texts{std::pair{name("film"), text()}, std::pair{name("sheet"), sheet(pictures_of_sheet)}};
    for (const auto& [file, content] : texts)
        if (content.size() > largest)
            refuse(file + " has " + std::to_string(content.size()) + " bytes, and pages want at most " +
                   std::to_string(largest) + ": take fewer frames, or fewer faces");
    for (const auto& [file, content] : texts) {
        const auto to = picture_folder() / file;
        const std::filesystem::path part = to.string() + "." + std::to_string(::getpid()) + ".part";
        std::error_code error;
        std::filesystem::create_directories(to.parent_path(), error);
        std::ofstream stream(part, std::ios::binary);
        stream << content;
        stream.close();
        if (stream) std::filesystem::rename(part, to, error);
        if (!stream || error) {
            std::clog << "picture skipped: " << to.string() << " cannot be written\n";
            std::filesystem::remove(part, error);
            return false;
        }
        std::clog << "picture: " << to.string() << '\n';
    }
    return true;
}

inline void Film::refuse(const std::string& why) const { throw std::invalid_argument("Film " + number_ + ": " + why); }

} // namespace ansatz::workbook
