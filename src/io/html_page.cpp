// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/html_page.hpp"

#include <tinyxml2.h>

#include "io/html_style.hpp"
#include "io/xml_text.hpp"

namespace straightedge::io {
namespace {

using tinyxml2::XMLElement;

constexpr std::int32_t small_figure = 240;  // pixels; legends stand beside their picture

XMLElement* add(XMLElement* parent, const char* name, const char* kind = nullptr) {
  XMLElement* element = parent->InsertNewChildElement(name);
  if (kind != nullptr) element->SetAttribute("class", kind);
  return element;
}

XMLElement* add_text(XMLElement* parent, const char* name, const std::string& text) {
  XMLElement* element = add(parent, name);
  // HTML does not know <td/>: an element without text would swallow what follows.
  element->SetText(text.empty() ? " " : text_for_xml(text).c_str());
  return element;
}

void add_head(XMLElement* root, const std::string& title) {
  XMLElement* head = add(root, "head");
  add(head, "meta")->SetAttribute("charset", "utf-8");
  XMLElement* viewport = add(head, "meta");
  viewport->SetAttribute("name", "viewport");
  viewport->SetAttribute("content", "width=device-width, initial-scale=1");
  add_text(head, "title", title);
  add(head, "style")->SetText(html_style);
}

void add_facts(XMLElement* parent, const std::vector<HtmlFact>& facts) {
  if (facts.empty()) return;
  XMLElement* body = add(add(parent, "table", "facts"), "tbody");
  for (const HtmlFact& fact : facts) {
    XMLElement* row = add(body, "tr");
    add_text(row, "th", fact.label)->SetAttribute("scope", "row");
    add_text(row, "td", fact.value)->SetAttribute("id", fact.id.c_str());
  }
}

void add_contents(XMLElement* body, const std::vector<HtmlSection>& sections) {
  XMLElement* nav = add(body, "nav");
  nav->SetAttribute("aria-label", "Stages");
  XMLElement* list = add(nav, "ol");
  for (const HtmlSection& section : sections) {
    add_text(add(list, "li"), "a", section.title)->SetAttribute("href", ("#" + section.id).c_str());
  }
}

void add_figures(XMLElement* parent, const std::vector<HtmlFigure>& figures) {
  if (figures.empty()) return;
  XMLElement* row = add(parent, "div", "figures");
  for (const HtmlFigure& shown : figures) {
    XMLElement* figure = add(row, "figure", shown.size.width <= small_figure ? "small" : nullptr);
    XMLElement* link = add(figure, "a");
    link->SetAttribute("href", shown.file.c_str());
    XMLElement* picture = add(link, "img");
    picture->SetAttribute("src", shown.file.c_str());
    picture->SetAttribute("width", shown.size.width);
    picture->SetAttribute("height", shown.size.height);
    picture->SetAttribute("alt", text_for_xml(shown.alt).c_str());
    add_text(figure, "figcaption", shown.caption);
  }
}

void add_table(XMLElement* parent, const HtmlTable& content) {
  XMLElement* table = add(parent, "table", "numbers");
  add_text(table, "caption", content.caption);
  XMLElement* head = add(add(table, "thead"), "tr");
  for (const std::string& name : content.head) add_text(head, "th", name)->SetAttribute("scope", "col");
  XMLElement* body = add(table, "tbody");
  for (const std::vector<std::string>& cells : content.rows) {
    XMLElement* row = add(body, "tr");
    for (const std::string& cell : cells) add_text(row, "td", cell);
  }
}

void add_sources(XMLElement* parent, const std::vector<std::string>& sources) {
  if (sources.empty()) return;
  XMLElement* line = add(parent, "p", "sources");
  line->InsertNewText("Read on in ");
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (i > 0) line->InsertNewText(i + 1 == sources.size() ? " and " : ", ");
    add_text(line, "code", sources[i]);
  }
}

void add_section(XMLElement* body, const HtmlSection& content) {
  XMLElement* section = add(body, "section");
  section->SetAttribute("id", content.id.c_str());
  add_text(section, "h2", content.title);
  for (const std::string& text : content.paragraphs) add_text(section, "p", text);
  add_figures(section, content.figures);
  add_facts(section, content.facts);
  for (const HtmlTable& table : content.tables) add_table(section, table);
  add_sources(section, content.sources);
}

void add_zoom(XMLElement* body) {
  XMLElement* dialog = add(body, "dialog");
  dialog->SetAttribute("id", "viewer");
  dialog->SetAttribute("aria-label", "Enlarged picture");
  XMLElement* bar = add(dialog, "div", "bar");
  const auto button = [bar](const char* id, const char* label, const char* text) {
    XMLElement* element = add_text(bar, "button", text);
    element->SetAttribute("id", id);
    element->SetAttribute("aria-label", label);
  };
  button("smaller", "smaller", "\u2212");
  button("larger", "larger", "+");
  button("close", "close", "Close");
  add_text(bar, "span", "");
  XMLElement* picture = add(add(dialog, "div", "view"), "img");
  picture->SetAttribute("alt", "");
  add(body, "script")->SetText(html_script);
}

}  // namespace

std::string html_from_page(const HtmlPage& page) {
  tinyxml2::XMLDocument document;
  document.InsertEndChild(document.NewUnknown("DOCTYPE html"));
  XMLElement* root = document.NewElement("html");
  document.InsertEndChild(root);
  root->SetAttribute("lang", "en");
  add_head(root, page.title);
  XMLElement* body = add(root, "body");
  XMLElement* main = add(body, "main");
  add_text(main, "h1", page.title);
  for (const std::string& text : page.introduction) add_text(main, "p", text);
  add_facts(main, page.facts);
  add_contents(main, page.sections);
  for (const HtmlSection& section : page.sections) add_section(main, section);
  add_text(body, "footer", page.footer);
  add_zoom(body);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace straightedge::io
