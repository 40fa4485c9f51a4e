// The page as its user sees it: what stands there and what can be pressed, by the names that a
// screen reader says. Waits end by themselves (support/browser.js).
export class PrinterPage {
  constructor(page) {
    this.page = page;
    page.on('dialog', (dialog) => dialog.accept());
    this.state = page.locator('#state');
    this.fault = page.getByRole('alert');
    this.emergencyStop = page.getByRole('button', {name: 'Emergency stop'});
    this.progress = page.getByRole('progressbar', {name: 'printed'});
    this.upload = page.locator('#upload');
    this.layer = page.getByRole('slider', {name: 'Layer'});
  }

  static async open(page, url) {
    await page.goto(url);
    const opened = new PrinterPage(page);
    await opened.says(opened.state, /connected/);
    return opened;
  }

  // Loads the page anew, as the same user.
  async again() {
    await this.page.reload();
    await this.until(() => document.querySelector('#state').textContent !== 'connecting');
  }

  button(name) {
    return this.page.getByRole('button', {name, exact: true});
  }

  press(name) {
    return this.button(name).click();
  }

  field(label) {
    return this.page.getByLabel(label, {exact: true});
  }

  // What is set at once, beside what is changed in the layers to come.
  dial(label) {
    return this.page.locator('#control').getByLabel(label, {exact: true});
  }

  // Waits until `locator` shows what matches.
  says(locator, pattern) {
    return locator.filter({hasText: pattern}).waitFor();
  }

  // Waits until `holds` of the page's document.
  until(holds, argument) {
    return this.page.waitForFunction(holds, argument);
  }

  untilEnabled(name) {
    return this.until((label) => [...document.querySelectorAll('button')]
      .some((button) => (button.ariaLabel ?? button.textContent).trim() === label && !button.disabled), name);
  }

  // Drops a file onto the place for files, as from a file manager.
  async drop(name, text) {
    const dataTransfer = await this.page.evaluateHandle(([fileName, content]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([content], fileName));
      return transfer;
    }, [name, text]);
    for (const type of ['dragover', 'drop']) await this.page.dispatchEvent('#drop', type, {dataTransfer});
  }

  async put(name, text) {
    await this.upload.setInputFiles({name, mimeType: 'text/plain', buffer: Buffer.from(text)});
    await this.file(name).waitFor();
  }

  file(name) {
    return this.page.locator('#files').getByRole('listitem').filter({hasText: name});
  }

  job(id) {
    const number = this.page.getByText(String(id), {exact: true});
    return this.page.locator('#jobs').getByRole('listitem').filter({has: number});
  }

  async showLayers(name) {
    await this.press(`Show layers of ${name}`);
    await this.until(() => document.querySelector('#layer-text').textContent !== '');
  }

  // Says a line to the printer.
  async say(line) {
    await this.page.locator('#say').fill(line);
    await this.press('Say it');
  }

  // Waits until a file has its picture.
  pictured(name) {
    return this.until((file) => {
      const copy = new OffscreenCanvas(1, 1).getContext('2d');
      copy.drawImage(document.querySelector(`[aria-label="picture of ${file}"]`), -72, -72);
      return copy.getImageData(0, 0, 1, 1).data[3] > 0;
    }, name);
  }

  // What `canvas` shows, for comparison.
  pixels(canvas) {
    return this.page.locator(canvas).evaluate((element) => element.toDataURL());
  }

  // The share of `canvas` that has been drawn on.
  drawn(canvas) {
    return this.page.locator(canvas).evaluate((element) => {
      const copy = new OffscreenCanvas(element.width, element.height).getContext('2d');
      copy.drawImage(element, 0, 0);
      const {data} = copy.getImageData(0, 0, element.width, element.height);
      let pixels = 0;
      for (let i = 3; i < data.length; i += 4) pixels += data[i] > 0;
      return pixels / (data.length / 4);
    });
  }
}
