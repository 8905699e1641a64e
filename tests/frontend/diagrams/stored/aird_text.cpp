// SPDX-License-Identifier: Apache-2.0
#include "tests/frontend/diagrams/stored/aird_text.hpp"

#include <fmt/format.h>

namespace robochart::diagrams {
namespace {

std::string target_and_mapping(const std::string& href, const std::string& mapping) {
    return fmt::format(
        "<target xmi:type=\"robochart:Any\" href=\"{}\"/>"
        "<actualMapping href=\"platform:/plugin/x.odesign#//@ownedRepresentations[name='SpecificationID']/"
        "@mappings[name='{}']\"/>",
        href, mapping);
}

}  // namespace

std::string aird_text(const std::string& diagrams) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<xmi:XMI xmlns:xmi=\"http://www.omg.org/XMI\" xmlns:diagram=\"d\" xmlns:notation=\"n\" xmlns:x=\"x\">\n"
           "<viewpoint:DAnalysis xmlns:viewpoint=\"v\"><semanticResources>a.rct</semanticResources>"
           "</viewpoint:DAnalysis>\n" +
           diagrams + "</xmi:XMI>\n";
}

std::string aird_diagram(const std::string& elements, const std::string& shapes, const std::string& lines) {
    return "<diagram:DSemanticDiagram uid=\"_d\">\n<ownedAnnotationEntries source=\"GMF_DIAGRAMS\">"
           "<data xmi:type=\"notation:Diagram\" type=\"Sirius\">\n" +
           shapes + lines + "</data></ownedAnnotationEntries>\n" + elements + "</diagram:DSemanticDiagram>\n";
}

std::string element(const std::string& id, const std::string& name, const std::string& href, const std::string& mapping,
                    const std::string& inner) {
    return fmt::format("<ownedDiagramElements uid=\"{}\" name=\"{}\">{}{}</ownedDiagramElements>\n", id, name,
                       target_and_mapping(href, mapping), inner);
}

std::string line_element(const std::string& id, const std::string& name, const std::string& href,
                         const std::string& mapping, const std::string& source, const std::string& target) {
    return fmt::format(
        "<ownedDiagramElements uid=\"{}\" name=\"{}\" sourceNode=\"{}\" targetNode=\"{}\">{}</ownedDiagramElements>\n",
        id, name, source, target, target_and_mapping(href, mapping));
}

std::string shape(int type, const std::string& id, const std::string& bounds, const std::string& inner) {
    return fmt::format(
        "<children xmi:type=\"notation:Node\" type=\"{}\" element=\"{}\">{}"
        "<layoutConstraint xmi:type=\"notation:Bounds\" {}/></children>\n",
        type, id, inner, bounds);
}

std::string container(const std::string& inner, bool title) {
    return fmt::format("<children type=\"5006\"{}/><children type=\"7001\">{}</children>",
                       title ? "" : " visible=\"false\"", inner);
}

std::string line(const std::string& id, const std::string& points, const std::string& more) {
    return fmt::format(
        "<edges type=\"4001\" element=\"{}\"><styles xmi:type=\"notation:ConnectorStyle\" routing=\"Rectilinear\"/>"
        "<bendpoints points=\"{}\"/>{}</edges>\n",
        id, points, more);
}

}  // namespace robochart::diagrams
