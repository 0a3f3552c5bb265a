// Where a shot is looked at contact by contact: its release, then each row of its event log.
"use strict";

const Stops = (() => {
  /** Return the time of a shot's release, and of each of its events, s. */
  function times(shot) {
    return [0, ...shot.events.map((event) => event.time)];
  }

  /** Return the last stop that a time has come to. */
  function at(shot, time) {
    return times(shot).findLastIndex((stop) => stop <= time);
  }

  /**
   * Return the stop before (-1) or after (1) the one come to, at a time since; null if there is
   * none. Several may be at one time: a contact, and the roll that begins with it.
   */
  function beside(shot, stop, time, way) {
    const all = times(shot);
    if (way < 0 && time > all[stop]) return stop;
    return stop + way in all ? stop + way : null;
  }

  return { at, beside, times };
})();
