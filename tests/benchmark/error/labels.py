"""Direct labels beside marks: each goes where it covers no mark and no other label."""

from matplotlib.text import Text
from matplotlib.transforms import Bbox

# Places around a mark, in points, with the text's own anchor: the near ones first.
PLACES = [(dx * r, dy * r, ha, va)
          for r in (1, 1.8, 2.8, 4, 5.5, 7.5, 10, 13)
          for dx, dy, ha, va in ((6, 0, "left", "center"), (-6, 0, "right", "center"), (5, 5, "left", "bottom"),
                                 (-5, 5, "right", "bottom"), (5, -5, "left", "top"), (-5, -5, "right", "top"),
                                 (0, 6, "center", "bottom"), (0, -6, "center", "top"))]
MARK = 4


class Labels:
    """Collects the labels of one panel; place() needs a figure that was drawn."""

    def __init__(self):
        self.wanted = []
        self.lines = []

    def add(self, axes, x, y, text, size=7, colour="black"):
        self.wanted.append((axes, x, y, text, size, colour))

    def avoid(self, axes, points):
        """No label shall cover the line through these points."""
        self.lines.append((axes, points))

    def place(self, figure):
        renderer = figure.canvas.get_renderer()
        points = figure.dpi / 72
        taken = []
        for axes, x, y, *_ in self.wanted:
            at = axes.transData.transform((x, y))
            taken.append(Bbox([at - MARK * points, at + MARK * points]))
        own = list(taken)
        for axes, line in self.lines:
            taken += boxes_along([axes.transData.transform(point) for point in line], points)
        # The long names first: the short ones find a place more easily.
        for index in sorted(range(len(self.wanted)), key=lambda i: (-self.wanted[i][4], -len(self.wanted[i][3]))):
            self._place_one(index, own[index], taken, renderer)

    def _place_one(self, index, mark, taken, renderer):
        axes, x, y, text, size, colour = self.wanted[index]
        frame = axes.get_window_extent(renderer)
        best = None
        for dx, dy, ha, va in PLACES:
            label = axes.annotate(text, (x, y), (dx, dy), textcoords="offset points", ha=ha, va=va,
                                  fontsize=size, color=colour, annotation_clip=False, zorder=4,
                                  arrowprops={"arrowstyle": "-", "linewidth": 0.3, "color": colour,
                                              "shrinkA": 0, "shrinkB": 2} if abs(dx) + abs(dy) > 13 else None)
            label.update_positions(renderer)
            box = Text.get_window_extent(label, renderer)  # of the text alone, without its line
            overlap = sum(area(Bbox.intersection(box, other)) for other in taken if other is not mark)
            outside = area(box) - area(Bbox.intersection(box, frame))
            cost = overlap + outside
            if best is None or cost < best[0]:
                if best is not None:
                    best[1].remove()
                best = (cost, label, box)
            else:
                label.remove()
            if cost == 0:
                break
        taken.append(best[2])


def boxes_along(corners, points):
    """Small boxes that cover a line on the screen."""
    boxes = []
    for (x, y), (u, v) in zip(corners, corners[1:]):
        steps = max(1, int(max(abs(u - x), abs(v - y)) / (3 * points)))
        for i in range(steps + 1):
            px, py = x + (u - x) * i / steps, y + (v - y) * i / steps
            boxes.append(Bbox([(px - points, py - points), (px + points, py + points)]))
    return boxes


def area(box):
    return 0 if box is None else abs(box.width * box.height)
