// SPDX-License-Identifier: BSL-1.0
// Formulas are read, not played with: without the menu there is nothing that would have to be loaded from elsewhere.
MathJax.Hub.Config({ showMathMenu: false, messageStyle: "none", menuSettings: { zoom: "None" }, SVG: { scale: 95 } });
