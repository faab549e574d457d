// Finding and making the elements of the page.

/**
 * The element with that id, which has to be of that type.
 * @template {Element} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
export function find(id, type) {
  const element = document.getElementById(id);
  if (!(element instanceof type)) throw new Error(`The page has no ${type.name} "${id}"`);
  return element;
}

/** @param {string} id */
export const button = (id) => find(id, HTMLButtonElement);

/**
 * A new element with these properties and children.
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Partial<HTMLElementTagNameMap[K]>} properties
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

/**
 * Shows or hides an element.
 * @param {HTMLElement} element
 * @param {boolean} isShown
 */
export function show(element, isShown) {
  if (element.hidden === isShown) element.hidden = !isShown;
}

/**
 * Whether keys typed there are text, or choose something there.
 * @param {EventTarget | null} target
 */
export function takesKeys(target) {
  if (!(target instanceof HTMLElement)) return false;
  return target.matches("input, select, textarea") || target.closest("dialog") !== null;
}

/**
 * What the browser keeps for this page; null where it refuses to, as it may for a file.
 * @param {string} name
 */
export function kept(name) {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

/**
 * @param {string} name
 * @param {string} value
 */
export function keep(name, value) {
  try {
    localStorage.setItem(name, value);
  } catch {
    /* then it holds until the page is closed */
  }
}
