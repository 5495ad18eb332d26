// @ts-check
// This decides how much is drawn of a heavy picture while something moves, by how long pictures take: a machine without
// a graphics card is to turn it, too.

import {kGrids, levelFor} from './coarse.js';

/** Milliseconds that a picture should take, and between which nothing is changed: 30 a second, and a little more. */
const kGoal = 27, kQuick = 20, kSlow = 35;
const kLeastBudget = 20000, kFirstBudget = 400000, kMostBudget = 8e6;
/** With fewer triangles shapes suffer more than by fewer pixels, which come first. */
const kPlainBudget = 100000;
/** Of the pixels of the screen along each side. */
const kResolutions = [1, 0.75, 0.5];
/** Of what stands still so many triangles are drawn by any machine, though it take a second. */
const kStillBudget = 1.5e6;
/** Pixels that may become one: at least this while something moves, at most this while nothing does. */
const kMovingCell = 2, kStillCell = 1;
/** Beyond that bodies are hardly known again. */
const kMostCell = 24;

export class Quality {
  constructor() {
    /** Triangles of a picture while something moves. */
    this.budget = kFirstBudget;
    this.step = 0;
  }

  /** Of the pixels of the screen along each side while something moves. */
  get resolution() {
    return kResolutions[this.step];
  }

  /** After each picture of a motion. @param {number} milliseconds */
  took(milliseconds) {
    const isPlain = this.budget >= kPlainBudget;
    if (milliseconds > kSlow) {
      const less = this.budget * Math.max(0.25, kGoal / milliseconds);
      if (this.budget > kPlainBudget) this.budget = Math.max(kPlainBudget, less);
      else if (this.step + 1 < kResolutions.length) ++this.step;
      else this.budget = Math.max(kLeastBudget, less);
    } else if (milliseconds < kQuick) {
      if (isPlain && this.step > 0) --this.step;
      else this.budget = Math.min(isPlain ? kMostBudget : kPlainBudget, this.budget * 1.5);
    }
  }

  /**
   * Returns how many pixels may become one, or 0 for none.
   * @param {{pixels: number, countAt: (level: number) => number}[]} bodies the size of each on the screen, and how many
   *   triangles it has at a level
   * @param {boolean} isMoving
   */
  cell(bodies, isMoving) {
    const all = bodies.reduce((sum, body) => sum + body.countAt(kGrids.length), 0);
    if (all <= Math.min(this.budget, kFirstBudget)) return 0;
    const countOf = (/** @type {number} */ of) => bodies.reduce((sum, {pixels, countAt}) => sum + countAt(levelFor(pixels, of)), 0);
    // For a picture that stays one waits a little.
    const budget = isMoving ? this.budget : Math.max(kStillBudget, 8 * this.budget);
    let cell = isMoving ? kMovingCell : kStillCell;
    while (cell < kMostCell && countOf(cell) > budget) cell *= 1.5;
    return cell;
  }
}
