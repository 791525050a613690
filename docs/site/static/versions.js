// A menu of the versions of the site. The folder around them has a list, which `scripts/site` writes.

const here = new URL(document.documentElement.dataset.content_root, location.href);

globalThis.exactCcdVersions = (names) => {
  const menu = document.createElement("select");
  menu.className = "versions";
  menu.ariaLabel = "version";
  const current = here.pathname.split("/").at(-2);
  for (const name of names) menu.append(new Option(name, name, false, name === current));
  menu.addEventListener("change", () => {
    location.href = new URL(`../${menu.value}/index.html`, here).href;
  });
  document.querySelector(".sidebar-brand")?.after(menu);
};

document.addEventListener("DOMContentLoaded", () => {
  const list = document.createElement("script");
  list.src = new URL("../versions.js", here).href;
  document.head.append(list);
});
