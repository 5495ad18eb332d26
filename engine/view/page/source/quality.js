// @ts-check
// How much is drawn of a heavy picture while something moves, by how long pictures take: a machine without a graphics
// card is to turn it, too.

import {kGrids, levelFor} from './coarse.js';

/** Milliseconds that a picture should take, and between which nothing is changed. */
const kGoal = 33, kQuick = 22, kSlow = 45;
const kLeastBudget = 20000, kFirstBudget = 400000, kMostBudget = 8e6;
/** Pixels that may become one: at least this while something moves, at most this while nothing does. */
const kMovingCell = 2, kStillCell = 1;
/** Beyond that bodies are hardly known again. */
const kMostCell = 24;

export class Quality {
  constructor() {
    /** Triangles of a picture while something moves. */
    this.budget = kFirstBudget;
    /** Of the pixels of the screen along each side while something moves: 1 or 0.5. */
    this.resolution = 1;
  }

  /** After each picture of a motion. @param {number} milliseconds */
  took(milliseconds) {
    if (milliseconds > kSlow) {
      if (this.budget === kLeastBudget) this.resolution = 0.5;
      this.budget = Math.max(kLeastBudget, this.budget * Math.max(0.25, kGoal / milliseconds));
    } else if (milliseconds < kQuick) {
      if (this.resolution < 1) this.resolution = 1;
      else this.budget = Math.min(kMostBudget, this.budget * 1.5);
    }
  }

  /** Whether this machine draws quickly enough to show all once nothing moves. @param {number} triangles of all */
  drawsAll(triangles) {
    return triangles <= 8 * this.budget;
  }

  /**
   * How many pixels may become one, 0: none.
   * @param {{pixels: number, countAt: (level: number) => number}[]} bodies the size of each on the screen, and how many
   *   triangles it has at a level
   * @param {boolean} isMoving
   */
  cell(bodies, isMoving) {
    const all = bodies.reduce((sum, body) => sum + body.countAt(kGrids.length), 0);
    if (all <= Math.min(this.budget, kFirstBudget)) return 0;
    if (!isMoving && this.drawsAll(all)) return kStillCell;
    // For a picture that stays one waits a little.
    const budget = isMoving ? this.budget : Math.max(kFirstBudget, this.budget);
    let cell = kMovingCell;
    while (cell < kMostCell && bodies.reduce((sum, {pixels, countAt}) => sum + countAt(levelFor(pixels, cell)), 0) > budget)
      cell *= 1.5;
    return cell;
  }
}
