
/** The answer to a request for /svg?seed=ada&width=72&emotion=joy: a picture, or 400 and a sentence. */
export function respond(request: { url: string; method?: string }): Promise<Response>;

/** What of node's http.Server pages need; it is one. */
export interface Listening {
  address(): string | { port: number; address: string; family: string } | null;
  close(closed?: (error?: Error) => void): unknown;
}

/** Serves them by node; by default to this machine alone, on port 6437. */
export function listen(port?: number, host?: string): Promise<Listening>;
