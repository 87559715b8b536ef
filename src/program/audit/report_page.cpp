// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report_page.h"

namespace corral::program {

namespace {

constexpr std::string_view style = R"(
body { font: 16px/1.45 Georgia, "DejaVu Serif", serif; color: #1a1a1a; background: #fff; max-width: 1080px;
       margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 2rem; margin: 0 0 .4rem; } h2 { font-size: 1.35rem; margin: 2.4rem 0 .3rem; }
p { max-width: 46rem; margin: .3rem 0 1rem; }
table { border-collapse: collapse; margin: .6rem 0 1.2rem; font-size: .92rem; }
th { font-weight: normal; text-align: left; color: #555; border-bottom: 1px solid #999; padding: .15rem .9rem .15rem 0;
     vertical-align: bottom; }
td { padding: .15rem .9rem .15rem 0; border-bottom: 1px solid #e6e6e6; vertical-align: top; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
code, pre { font: .84rem/1.4 "DejaVu Sans Mono", Menlo, Consolas, monospace; }
pre { background: #f6f6f4; padding: .6rem .8rem; overflow-x: auto; white-space: pre-wrap; overflow-wrap: anywhere; }
svg { display: block; max-width: 100%; height: auto; } svg text { font: 13px Georgia, "DejaVu Serif", serif; }
h3 { font-size: 1.05rem; margin: 1.4rem 0 .3rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(400px, 1fr)); gap: .6rem 1.2rem; }
.legend { max-width: none; font-size: .85rem; } .legend span { white-space: nowrap; margin-right: 1.1em; }
.legend svg { display: inline-block; vertical-align: middle; }
.good { color: #1b6e3a; } .bad { color: #b00020; } .note { color: #555; font-size: .9rem; }
.key { display: inline-block; width: .8em; height: .8em; vertical-align: -.05em; }
sup, sub { font-size: .72em; line-height: 0; }
)";

} // namespace

std::string escaped(std::string_view text)
{
  std::string html;
  for (const char c : text) {
    if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '&')
      html += "&amp;";
    else if (c == '"')
      html += "&quot;";
    else
      html += c;
  }
  return html;
}

std::string report_page(std::string_view title, std::string_view body)
{
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Corral: ";
  html.append(escaped(title)).append("</title>\n<style>").append(style).append("</style>\n</head>\n<body>\n<h1>");
  html.append(escaped(title)).append("</h1>\n").append(body).append("</body>\n</html>\n");
  return html;
}

} // namespace corral::program
