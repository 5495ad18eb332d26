"""Shape and filling say who it is, so that the plots can be read without colour."""

MARKERS = {"graze": "*", "baseline": "o", "peer": "s"}
COLOURS = {"graze": "#b3261e", "baseline": "#1b6ca8", "peer": "#3c3c3c"}
