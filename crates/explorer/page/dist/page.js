/* with three 0.187.0, MIT; preact 11.2.0, MIT */
"use strict";(()=>{var oe,gu,Pm,ri,Ol,no,_u,jr,xu,Fl,Ul,Im,zs=Symbol.for("pv"),io={},so=[],Lm=/^m(i|n|o|s|text|space)$/,kl=Array.isArray,yu=so.slice,Ii=Object.assign;function Pi(i){i&&i.parentNode&&i.remove()}function Qr(i,t,e,n,s){var r={type:i,props:t,key:e,ref:n,__k:null,__:null,__b:0,__e:null,__c:null,constructor:zs,__v:s||++gu,__i:-1,__u:0};return!s&&oe.vnode&&oe.vnode(r),r}function jt(i){return i.children}function to(i,t){this.props=i,this.context=t,this.__g=0}function oi(i,t){if(t==null)return i.__&&oi(i.__,i.__i+1);for(var e;t<i.__k.length;t++)if((e=i.__k[t])&&e.__e)return e.__e;return typeof i.type!="function"||i.props.__P?null:oi(i)}function Dm(i){var t,e=i.__v,n=e.__e,s=[],r=[],o=i.__P;o&&((t=Ii({constructor:zs},e)).__v=e.__v+1,oe.vnode&&oe.vnode(t),Bl(o,t,e,i.__n,o.namespaceURI,32&e.__u?[n]:null,s,n||oi(e),32&e.__u,r),t.__v=e.__v,t.__.__k[t.__i]=t,Tu(s,t,r),e.__=e.__e=null,t.__e!=n&&vu(t))}function vu(i){if((i=i.__)&&i.__c&&!i.props.__P)return i.__e=null,i.__k.some(function(t){return t&&(i.__e=t.__e)}),vu(i)}function pu(i){(8&i.__g||(i.__g|=8,ri.push(i),no++))&&Ol==oe.debounceRendering||((Ol=oe.debounceRendering)||queueMicrotask)(bu)}function bu(){try{for(var i,t=1;ri.length;)ri.length>t&&ri.sort(_u),i=ri.shift(),t=ri.length,8&i.__g&&Dm(i)}finally{(no=ri.length)&&(Ol||queueMicrotask)(bu)}}function Su(i,t,e,n,s,r,o,a,l,c,h){var f,u,d,g,x,m,_=n.__k||so,v=t.length;for(l=Nm(e,t,_,l,v),f=0;f<v;f++)(d=e.__k[f])!=null&&(u=~d.__i&&_[d.__i]||io,d.__i=f,m=Bl(i,d,u,s,r,o,a,l,c,h),g=d.__e,(u.ref!=d.ref||8&u.__u)&&(u.ref&&zl(u.ref,null,d,u),d.ref&&h.push(d.ref,d.__c||g,d)),x=x||g,4&d.__u?(l=Mu(d,l,i,!u.__v),u.__e&&(u.__e=null)):typeof d.type=="function"&&m!==void 0?l=m:g&&(l=g.nextSibling),d.__u&=-21);return e.__e=x,l}function Nm(i,t,e,n,s){var r,o,a,l,c,h,f,u,d,g=e.length,x=g,m=0,_=0,v=i.__k=Array(s);for(r=0;r<s;r++)(o=t[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[r]=Qr(null,o):kl(o)?o=v[r]=Qr(jt,{children:o}):o.constructor===zs&&o.__b?o=v[r]=Qr(o.type,o.props,o.key,o.ref,o.__v):v[r]=o,l=r+m,o.__=i,o.__b=i.__b+1,a=null,~(c=o.__i=Om(o,e,l,x))&&(x--,(a=e[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,_=1)):(~c||(s>g?m--:s<g&&m++),typeof o.type!="function"&&(o.__u|=4))):v[r]=null;if(_){for(h=[],f=[],r=0;r<s;r++)if((o=v[r])&&16&o.__u){for(m=0,u=h.length;m<u;)h[d=m+u>>1]<o.__i?m=d+1:u=d;h[m]=o.__i,f[r]=m+1}for(m=h.length;r--;)f[r]&&(f[r]==m?m--:v[r].__u|=4)}if(x)for(r=0;r<g;r++)!(a=e[r])||2&a.__u||(a.__e==n&&(n=oi(a)),Vl(a,a));return n}function Mu(i,t,e,n){var s,r,o,a;if(typeof i.type=="function"){if(i.props.__P)return t;if(s=i.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=i,t=Mu(s[r],t,e,!1));return t}for(t&&!t.parentNode&&(t=oi(i))&&!t.parentNode&&(t=null),o=i.__e,a=t;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!n&&e.moveBefore&&o.parentNode?e.moveBefore(o,t):e.insertBefore(o,t||null)),t=o;(t=t&&t.nextSibling)&&t.nodeType==8&&!t.data.startsWith("$s"););return t}function Om(i,t,e,n){var s,r=i.key,o=i.type,a=t[e],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return e;if(n>(l?1:0)){for(s=e-1;s>=0;s--)if((a=t[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=e+1;s<t.length;s++)if((a=t[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function mu(i,t,e){e==null&&(e=""),t[0]=="-"?i.setProperty(t,e):i[t]=e}function Jr(i,t,e,n,s){var r,o;if(t=="style")if(typeof e=="string")i.style.cssText=e;else{if(typeof n=="string"&&(i.style.cssText=n=""),n)for(t in n)e&&t in e||mu(i.style,t);if(e)for(t in e)n&&e[t]==n[t]||mu(i.style,t,e[t])}else if(t[0]=="o"&&t[1]=="n")typeof e!="function"&&(e=null),typeof n!="function"&&(n=null),(i.__e||(i.__e={}))[t]=e,e&&n||(o=Ul[t]||(Ul[t]=Um(t)),(i.__a||(i.__a={}))[t]=Fl,r=t!=(t=t.replace(xu,"$1")),(t=t.slice(2))[0]<"a"&&(t=t.toLowerCase()),e?i.addEventListener(t,o,r):i.removeEventListener(t,o,r));else{if(s=="http://www.w3.org/2000/svg")t=t.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(t!="width"&&t!="height"&&t!="href"&&t!="list"&&t!="form"&&t!="tabIndex"&&t!="download"&&t!="rowSpan"&&t!="colSpan"&&t!="role"&&t!="popover"&&t in i)try{return void(i[t]=e??"")}catch{}if(typeof e=="function")return;e==null||e===!1&&t[4]!="-"?i.removeAttribute(t):i.setAttribute(t,t=="popover"&&e==1?"":e)}}function Um(i){return function(t){var e=this.__e;if(e){if(e=e[i],t[jr]==null)t[jr]=Fl++;else if(t[jr]<this.__a[i])return;return e(oe.event?oe.event(t):t)}}}function Bl(i,t,e,n,s,r,o,a,l,c){var h,f,u,d,g,x,m,_,v,w,M,P,C,y,T,U,L,O,B=t.type;if(t.constructor!==zs)return null;128&e.__u&&(l=32&e.__u,h=e.__c.__z)&&(t.__u|=l,f=r=[],h.nodeType==8?a=eo(h,r):r.push(h),a=r[0]||a),(h=oe.__b)&&h(t);t:if(typeof B=="function"){u=o.length;try{if(_=t.props,v=(h=B.prototype)&&h.render,w=(h=B.contextType)&&n[h.__c],M=h?w?w.props.value:h.__:n,(d=e.__c)?(t.__c=d,2&d.__g&&(d.__g|=1)):(v?t.__c=d=new B(_,M):(t.__c=d=new to(_,M),d.constructor=B,d.render=km),w&&w.sub(d),d.state||(d.state={}),d.__n=n,d.__g|=8,d.__h=[],d.__k=[]),v&&(d.__s||(d.__s=d.state),B.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Ii({},d.__s)),Ii(d.__s,B.getDerivedStateFromProps(_,d.__s)))),g=d.props,x=d.state,d.__v=t,e.__c){if(_!==g&&v&&!B.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(_,M),t.__v==e.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(_,d.__s,M)===!1){t.__v!=e.__v&&(d.props=_,d.state=d.__s,d.__g&=-9),t.__e=e.__e,t.__k=e.__k,t.__k.some(function(H){H&&(H.__=t)}),so.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=oi(e);break t}d.componentWillUpdate&&d.componentWillUpdate(_,d.__s,M),v&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(g,x,m)})}else v&&!B.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),v&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=M,d.props=_,d.__P=i,d.__g&=-5,P=oe.__r,C=v?25:0;do d.__g&=-9,P&&P(t),h=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++C<25);v&&(so.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(n=Ii({},n,d.getChildContext())),v&&e.__c&&d.getSnapshotBeforeUpdate&&(m=d.getSnapshotBeforeUpdate(g,x)),y=h&&h.type===jt&&h.key==null?h.props.children:h,_.__P&&(h=a,s=(i=_.__P).namespaceURI,l=r=null,e.props&&e.props.__P!=i&&(e.__k.some(function(H){H&&Vl(H,H)}),e.__k=null),a=e.__k?oi(e,0):null),a=Su(i,kl(y)?y:[y],t,e,n,s,r,o,a,l,c),_.__P&&(t.__e=null,a=h),t.__u&=-161,f&&f.some(Pi),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(H){if(o.length=u,t.__v=null,l||r)if(H&&H.then){if(t.__u|=128|l,r){for(~(L=r.indexOf(a||void 0))||(L=r.length);(O=r[L-1])&&O.nodeType==8;)L--;for(;L<r.length;L++)if(O=r[L])if(r[L]=null,T){if(O==U)break}else{if(O.nodeType!=8)break;O.data.startsWith("$s")&&(U=eo(T=O))}}if(!T){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;T=a}(h=eo(T=t.__c.__z||(t.__c.__z=T)))?(t.__e=T,a=h):t.__e=a,a=a&&a.nextSibling}else r&&r.some(Pi);else t.__e=e.__e;t.__k||(t.__k=e.__k||[]),H&&H.then||wu(t),oe.__e(H,t,e)}}else a=t.__e=Fm(e.__e,t,e,n,s,r,o,l,c,i);return(h=oe.diffed)&&h(t),a}function eo(i,t){if(i&&i.nodeType==8&&i.data.startsWith("$s"))for(var e=1;i=i.nextSibling;){if(i.nodeType==8){if(i.data.startsWith("$s"))e++;else if(i.data.startsWith("/$s")&&!--e)return i}t&&t.push(i)}}function wu(i){i&&(i.__c&&(i.__c.__g|=4),i.__k&&i.__k.some(wu))}function Tu(i,t,e){for(var n=0;n<e.length;)zl(e[n++],e[n++],e[n++]);oe.__c&&oe.__c(t,i),i.some(function(s){try{i=s.__h,s.__h=[],i.some(function(r){r.call(s)})}catch(r){oe.__e(r,s.__v)}})}function Fm(i,t,e,n,s,r,o,a,l,c){var h,f,u,d,g,x,m,_,v=e.props||io,w=t.props,M=t.type;if(M=="svg"?s="http://www.w3.org/2000/svg":M=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(h=0;h<r.length;h++)if((g=r[h])&&(M?g.localName==M:g.nodeType==3)){i=g,r[h]=null;break}}if(!i){if(_=c.ownerDocument||document,!M)return _.createTextNode(w);i=_.createElementNS(s,M,w.is?w:c),a&&(oe.__m&&oe.__m(t,r),a=!1),r=null}if(M){if(c=M=="template"&&i.content||i,r=M=="textarea"&&w.defaultValue!=null?null:r&&yu.call(c.childNodes),!a&&r)for(v={},h=0;h<i.attributes.length;h++)v[(g=i.attributes[h]).name]=g.value;for(h in v)g=v[h],h=="dangerouslySetInnerHTML"?u=g:h=="children"||h in w||h=="value"&&"defaultValue"in w||h=="checked"&&"defaultChecked"in w||Jr(i,h,null,g,s);for(h in w)g=w[h],h=="children"?d=g:h=="dangerouslySetInnerHTML"?f=g:h=="value"?x=g:h=="checked"?m=g:a&&typeof g!="function"||v[h]===g||Jr(i,h,g,v[h],s);f?(a||u&&(f.__html==u.__html||f.__html==i.innerHTML)||(i.innerHTML=f.__html),t.__k=[]):(u&&(i.textContent=""),(M=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Lm.test(M))&&(s="http://www.w3.org/1999/xhtml"),Su(c,kl(d)?d:[d],t,e,n,s,r,o,r?r[0]:e.__k&&oi(e,0),a,l),r&&r.some(Pi)),a&&M!="textarea"||(h="value",M=="progress"&&x==null?i.removeAttribute(h):x==null||x===i[h]&&(M!="progress"||x)||Jr(i,h,x,v[h],s),h="checked",m!=null&&m!=i[h]&&Jr(i,h,m,v[h],s))}else v===w||a&&i.data==w||(i.data=w);return i}function zl(i,t,e,n){try{typeof i=="function"?t?t.__x=i(t)||1:n&&(n=n.__c||n.__e)&&(t=n.__x)&&(n.__x=null,typeof t=="function"?t():i(null)):i.current=t}catch(s){oe.__e(s,e)}}function Vl(i,t,e){var n,s,r,o;if(oe.unmount&&oe.unmount(i),!(n=i.ref)||n.current&&n.current!=i.__e||zl(n,null,t,i),n=i.__c){if(n.componentWillUnmount)try{n.componentWillUnmount()}catch(a){oe.__e(a,t)}n.__P=n.__n=null}if(n=i.__k)for(o=0;o<n.length;o++)n[o]&&Vl(n[o],t,typeof i.type!="function"||e&&!i.props.__P);!e&&(n=i.__c)&&(n=n.__z)&&(s=eo(n,r=[]))&&(n==i.__e&&r.some(Pi),Pi(s),Pi(n)),e||Pi(i.__e),i.__e=i.__c=i.__=null}function km(i,t,e){return this.constructor(i,e)}function Eu(i,t){var e,n,s,r;oe.__&&oe.__(i,t),t.nodeType==9&&(t=t.documentElement),n=(e=i&&32&i.__u)?null:t.__k,t.__k=Qr(jt,{children:[i]}),s=[],r=[],Bl(t,t.__k,n||io,io,t.namespaceURI,n?null:t.firstChild?yu.call(t.childNodes):null,s,n?n.__e:t.firstChild,e,r),Tu(s,t.__k,r),t.__k.props.children=null}oe={__e:function(i,t,e,n){for(var s,r,o;t=t.__;)if((s=t.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(i)),s.componentDidCatch&&(s.componentDidCatch(i,n||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){i=a}}throw no=0,i}},gu=0,Pm=function(i){return i!=null&&i.constructor===zs},to.prototype.setState=function(i,t){var e=this.__s;e&&e!=this.state||(e=this.__s=Ii({},this.state)),typeof i=="function"&&(i=i(Ii({},e),this.props)),i&&(Ii(e,i),this.__v&&(t&&this.__k.push(t),pu(this)))},to.prototype.forceUpdate=function(i){this.__v&&(this.__g|=4,i&&this.__h.push(i),pu(this))},to.prototype.render=jt,ri=[],no=0,_u=function(i,t){return i.__v.__b-t.__v.__b},jr=Symbol(),xu=/(PointerCapture)$|Capture$/i,Fl=0,Ul={},Im=0;var Gs,Ee,Gl,Au,Hl=Object.is,ro=0,Uu=[],Wl=[],Se=oe,Cu=Se.__b,Ru=Se.__r,Pu=Se.diffed,Iu=Se.__c,Lu=Se.unmount,Du=Se.__;function $l(i,t){Se.__h&&Se.__h(Ee,i,ro||t),ro=0;var e=Ee.__H||(Ee.__H={__:[],__h:[]});return i>=e.__.length&&e.__.push({}),e.__[i]}function le(i){return ro=1,ql(ku,i)}function ql(i,t,e){var n=$l(Gs++,2);if(n.t=i,!n.__c&&(n.__=[e?e(t):ku(void 0,t),function(r){var o=(n.__N||n.__)[0],a=n.t(o,r);Hl(o,a)||(n.__N=[a,n.__[1]],n.__c.setState({}))}],n.__c=Ee,!Ee.__f)){Ee.__f=!0;var s=Ee.shouldComponentUpdate;Ee.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,h=this.props!=r;if(l.__.some(function(u){u.__N&&(c=!0,Hl(u.__[0],u.__N[0])||(h=!0))}),s){var f=s.call(this,r,o,a);return c?f||h:f}return!c||h}}return n.__}function Qe(i,t){var e=$l(Gs++,3);!Se.__s&&Fu(e.__H,t)&&(e.__P=!0,e.__=i,e.u=t,Ee.__H.__h.push(e))}function sn(i){return ro=5,Yi(function(){return{current:i}},[])}function Yi(i,t){var e=$l(Gs++,7);return Fu(e.__H,t)&&(e.__=i(),e.__H=t),e.__}function Bm(){var i;do{for(;i=Wl.shift();)try{Vs(i)}catch(e){Se.__e(e,{__:(i=i.__P)&&i.__v})}for(;i=Uu.shift();){var t=i.__H;if(i.__P&&t)try{t.__h.some(Vs),t.__h.some(Xl),t.__h=[]}catch(e){t.__h=[],Se.__e(e,i.__v)}}}while(Wl.length)}Se.__b=function(i){Ee=null,Cu&&Cu(i)},Se.__=function(i,t){i&&t.__k&&t.__k.__m&&(i.__m=t.__k.__m),Du&&Du(i,t)},Se.__r=function(i){Ru&&Ru(i),Gs=0;var t=(Ee=i.__c).__H;t&&(Gl==Ee?Ee.__h=[]:(t.__h.some(Vs),t.__h.some(Xl),Gs=0),t.__h=[],t.__.some(function(e){e.__N&&(e.__=e.__N),e.u=e.__N=void 0})),Gl=Ee},Se.diffed=function(i){Pu&&Pu(i);var t=i.__c;t&&t.__H&&(t.__H.__h.length&&Ou(Uu.push(t)),t.__H.__.some(function(e){e.u&&(e.__H=e.u)})),Gl=Ee=null},Se.__c=function(i,t){t.some(function(e){try{e.__h.some(Vs),e.__h=e.__h.filter(function(n){return!n.__||Xl(n)})}catch(n){e.__h=[function(){throw n}]}}),Iu&&Iu(i,t)},Se.unmount=function(i){Lu&&Lu(i);var t,e,n=i.__c;n&&n.__H&&(n.__H.__.some(function(s){try{if(s.__P&&s.__c){if(e===void 0){for(e=i.__;e&&(!e.__c||!e.__c.__P);)e=e.__;e=e&&e.__c}s.__P=e,Ou(Wl.push(s))}else Vs(s)}catch(r){t=r}}),n.__H=void 0,t&&Se.__e(t,n.__v))};var Nu=typeof requestAnimationFrame=="function";function zm(i){var t,e=function(){clearTimeout(n),Nu&&cancelAnimationFrame(t),setTimeout(i)},n=setTimeout(e,35);Nu&&(t=requestAnimationFrame(e))}function Ou(i){i!=1&&Au==Se.requestAnimationFrame||((Au=Se.requestAnimationFrame)||zm)(Bm)}function Vs(i){var t=Ee,e=i.__c;typeof e=="function"&&(i.__c=void 0,e()),Ee=t}function Xl(i){var t=Ee;i.__c=i.__(),Ee=t}function Fu(i,t){return!i||i.length!=t.length||t.some(function(e,n){return!Hl(e,i[n])})}function ku(i,t){return typeof t=="function"?t(i):t}var yn=i=>new Uint16Array(i).fill(1024);function Bu(i){let t=i[0],e=t%9,n=Math.floor(t/9)%5,s=Math.floor(t/45);if(i.length<18||s>4)throw new Error("the engine is damaged: no LZMA data");let r=0;for(let at=7;at>=0;at--)r=r*256+i[5+at];let o=r<2**53,a=new Uint8Array(o?r:4*i.length),l=0,c=yn(192),h=yn(12),f=yn(12),u=yn(12),d=yn(12),g=yn(192),x=yn(768<<e+n),m=yn(256),_=yn(128),v=yn(16),w=2,M=w+128,P=M+128,C=yn(P+256),y=yn(P+256),T=14,U=new Uint32Array([4294967295,0]);for(let at=0;at<4;at++)U[1]=U[1]<<8|i[T++];let L=()=>{U[0]<<=8,U[1]=U[1]<<8|i[T++]},O=(at,W)=>{let it=at[W],ct=U[0],St=U[1],lt=Math.imul(ct>>>11,it)>>>0;return St<lt?(at[W]=it+(2048-it>>5),U[0]=lt,lt<16777216&&L(),0):(at[W]=it-(it>>5),U[0]=ct-lt,U[1]=St-lt,U[0]<16777216&&L(),1)},B=(at,W,it)=>{let ct=1;for(let St=0;St<it;St++)ct=2*ct+O(at,W+ct);return ct-(1<<it)},H=(at,W,it)=>{let[ct,St]=[1,0];for(let lt=0;lt<it;lt++){let Lt=O(at,W+ct);ct=2*ct+Lt,St|=Lt<<lt}return St},D=at=>{let W=0;for(let it=0;it<at;it++){U[0]>>>=1;let ct=U[1]>=U[0]?1:0;ct&&(U[1]-=U[0]),U[0]<16777216&&L(),W=2*W+ct}return W},Y=(at,W)=>O(at,0)?O(at,1)?16+B(at,P,8):8+B(at,M+(W<<3),3):B(at,w+(W<<3),3),J=at=>{let W=B(m,Math.min(at,3)*64,6);if(W<4)return W;let it=(W>>1)-1,ct=(2|W&1)*2**it;return W<14?ct+H(_,ct-W,it):ct+D(it-4)*16+H(v,0,4)},X=at=>{if(l+at<=a.length)return;if(o)throw new Error("the engine is damaged: more data than its stated size");let W=new Uint8Array(2*a.length+at);W.set(a),a=W},nt=0,[q,k,Z,dt]=[0,0,0,0];for(;;){if(o&&l===r)return a;if(T>i.length)throw new Error("the engine is damaged: its data end early");let at=l&(1<<s)-1;if(!O(c,(nt<<4)+at)){X(1);let it=l?a[l-1]:0,ct=768*(((l&(1<<n)-1)<<e)+(it>>8-e)),St=1;if(nt>=7){let lt=a[l-q-1];do{let Lt=lt>>7&1;lt<<=1;let xe=O(x,ct+(1+Lt<<8)+St);if(St=2*St+xe,Lt!==xe)break}while(St<256)}for(;St<256;)St=2*St+O(x,ct+St);a[l++]=St,nt=nt<4?0:nt<10?nt-3:nt-6;continue}let W;if(O(h,nt)){if(O(f,nt)){let it;O(u,nt)?(O(d,nt)?(it=dt,dt=Z):it=Z,Z=k):it=k,k=q,q=it}else if(!O(g,(nt<<4)+at)){X(1),nt=nt<7?9:11,a[l]=a[l-q-1],l++;continue}W=Y(y,at),nt=nt<7?8:11}else if([dt,Z,k]=[Z,k,q],W=Y(C,at),nt=nt<7?7:10,q=J(W),q===4294967295){if(o)throw new Error("the engine is damaged: less data than its stated size");return a.slice(0,l)}if(q>=l)throw new Error("the engine is damaged: a distance before the first byte");W+=2,X(W);for(let it=l-q-1;W>0;W--)a[l++]=a[it++]}}var oo=class i{constructor(t){this.exports=t}exports;static async start(t){let{instance:e}=await WebAssembly.instantiate(t,{});return new i(e.exports)}get memory(){return this.exports.memory.buffer.byteLength}ask(t){let e=new TextEncoder().encode(t),n=this.exports.percuss_request(e.length);new Uint8Array(this.exports.memory.buffer,n,e.length).set(e);let s=this.exports.percuss_answer();return new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer,this.exports.percuss_reply(),s))}};var Hs=class extends Error{};function Vm(){let i=document.getElementById("engine").textContent;return Bu(Uint8Array.from(atob(i.trim()),t=>t.charCodeAt(0)))}var ao=class i{constructor(t){this.bytes=t}bytes;worker;module;pending;memory=0;queue=Promise.resolve();static async start(){let t=new i(Vm());return await t.restart(),t}async restart(){try{let t=URL.createObjectURL(new Blob([`"use strict";(()=>{var t=class n{constructor(e){this.exports=e}exports;static async start(e){let{instance:r}=await WebAssembly.instantiate(e,{});return new n(r.exports)}get memory(){return this.exports.memory.buffer.byteLength}ask(e){let r=new TextEncoder().encode(e),s=this.exports.percuss_request(r.length);new Uint8Array(this.exports.memory.buffer,s,r.length).set(r);let a=this.exports.percuss_answer();return new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer,this.exports.percuss_reply(),a))}};var o;self.onmessage=async n=>{let{bytes:e,request:r}=n.data;try{e&&(o=t.start(e));let s=await o;self.postMessage(e?{ready:!0}:{reply:s.ask(r),memory:s.memory})}catch(s){o=void 0,self.postMessage({failed:String(s)})}};})();
`],{type:"text/javascript"}));this.worker=new Worker(t),URL.revokeObjectURL(t),await this.post({bytes:this.bytes})}catch{this.worker=void 0,this.module=await oo.start(this.bytes)}}post(t){return new Promise((e,n)=>{let s=this.worker;this.pending={resolve:e,reject:n},s.onmessage=({data:r})=>{this.pending=void 0,this.memory=r.memory??this.memory,r.failed?n(new Error(r.failed)):e(r.reply)},s.onerror=r=>{r.preventDefault(),n(new Error(r.message||"the worker did not start"))},s.postMessage(t)})}ask(t){let e=async()=>{let s=JSON.stringify(t),r=this.worker?await this.post({request:s}):this.module.ask(s);return JSON.parse(r)},n=this.queue.then(e);return this.queue=n.catch(()=>{}),n}async end(){if(!this.worker)return;this.worker.terminate();let t=this.pending;this.pending=void 0,await this.restart(),t?.reject(new Hs("ended"))}};var Yl={restitution:"0.3",stiffness:"200 N/mm",speed:"1 m/s",law:"kelvin-voigt",tool:"mujoco",stop:"",impactRestitution:"0.3",impactSpeed:"1 m/s",impactStiffness:"",impactInTime:"",region:"chest",limit:"force",limitValue:"",area:"1 cm2",load:"0",further:{}},zu={result:[],design:[],kinematics:["kinematics"],safe:["safe"],impact:["impact","damper"]},Vu=1e4,co=class{constructor(t,e,n){this.ask=t;this.present=e;this.changed=n}ask;present;changed;settings={...Yl};leftOut={};results={};shown=new Set;tab="result";closed=new Set;study;run=0;facets=[];moment;isShown(t){return this.wanted().includes(t)}wanted(){return[...this.shown,...zu[this.tab].filter(t=>!this.closed.has(t))]}turnTo(t){!t||t===this.tab||!Object.hasOwn(zu,t)||(this.tab=t,this.forget())}fold(t,e){e===this.closed.has(t)&&(e?this.closed.delete(t):this.closed.add(t),this.forget())}isOpen(t){return!this.closed.has(t)}forget(){let t=this.wanted();this.results=Object.fromEntries(Object.entries(this.results).filter(([e])=>t.includes(e))),this.study=void 0,this.changed(),this.refresh()}show(t,e){e!==this.shown.has(t)&&(e?this.shown.add(t):this.shown.delete(t),this.study=void 0,this.changed(),this.refresh())}set(t){Object.assign(this.settings,t),this.study=void 0,this.changed(),this.refresh()}momentOf({force:t}){return Math.min(this.moment??t.indexOf(Math.max(...t)),t.length-1)}isFresh(){return this.wanted().length===0||this.study===this.present().study}clear(){this.results={},this.moment=void 0,this.tab="result",Object.assign(this.settings,{stop:"",further:{}}),this.leftOut={},this.study=void 0}begin({damping:t,impact:e,safe_speed:n}={}){let s={};if(t){let{restitution:r,stiffness:o,speed:a,law:l,limit:c,for:h,output:f,...u}=t,d=Object.entries(u).filter(g=>typeof g[1]!="object");Object.assign(s,{...Zl({restitution:r,law:l,stiffness:c||u.exponent?o:lo(o,"N/m")}),speed:Zi(c?a:lo(a,"m/s")),stop:Zi(c),tool:[h].flat().map(Zi).find(g=>g&&g!=="all")??Yl.tool,further:Object.fromEntries(d)}),this.leftOut.damper=Object.keys(u).filter(g=>typeof u[g]=="object")}if(e){let{restitution:r,speed:o,stiffness:a,in_time:l,...c}=e;Object.assign(s,Zl({impactRestitution:r,impactSpeed:lo(o,"m/s"),impactStiffness:c.exponent?a:lo(a,"N/m"),impactInTime:l?"yes":""})),this.leftOut.impact=Object.keys(c)}if(n){let{region:r,area:o,load:a,...l}=n,c=Jl.find(h=>l[h]!==void 0)??Yl.limit;Object.assign(s,{...Zl({area:o,load:a}),region:Zi(r),limit:c,limitValue:Zi(l[c])}),this.leftOut.safe=Object.keys(l).filter(h=>h!==c)}this.set(s)}async refresh(){let{study:t,state:e}=this.present();if(!t||this.study===t)return;let n=this.wanted();if(!n.length)return;let s=++this.run;for(let r of n){let o=await this.one(r,t,e);if(s!==this.run||this.present().study!==t)return;this.results={...this.results,[r]:o},this.changed()}this.study=t,this.changed()}one(t,e,n){let s=this.settings;switch(t){case"damper":return this.ask({do:"damp",question:e,damping:{restitution:Kl(s.restitution),stiffness:Li(s.stiffness),...s.speed.trim()?{speed:Li(s.speed)}:{},law:s.law,for:[s.tool],...s.stop?{limit:s.stop}:{},...s.further}});case"impact":return this.ask({do:"impact",question:e,impact:{restitution:Kl(s.impactRestitution),speed:Li(s.impactSpeed.trim()||"1 m/s"),...s.impactStiffness.trim()?{stiffness:Li(s.impactStiffness)}:{},...s.impactInTime?{in_time:!0}:{}}});case"safe":return this.ask({do:"safe-speed",question:e,safe_speed:{...s.region?{region:s.region}:{},...s.limitValue.trim()?{[s.limit]:Li(s.limitValue)}:{},...s.limit==="pressure"?{area:Li(s.area)}:{},load:Li(s.load.trim()||"0")}});case"kinematics":return this.ask({do:"kinematics",model:e.model,state:n});case"directions":return this.ask({do:"directions",question:e});case"map":return this.map(e)}}async map(t){let e=new Map,n=this.run;for(let{link:s,name:r,contacts:o}of this.facets){if(t.contact.against===r)continue;let a=[];for(let l=0;l<o.length;l+=Vu){let c=await this.ask({do:"map",question:t,link:r,contacts:o.slice(l,l+Vu)});if(n!==this.run||!c)return;if("refused"in c)return c;a.push(...c.ok)}e.set(s,a)}return{ok:e}}},Jl=["force","pressure","energy","momentum"],Zi=i=>i==null?"":String(i),lo=(i,t)=>typeof i=="number"?`${i} ${t}`:i,Zl=i=>Object.fromEntries(Object.entries(i).filter(([,t])=>t!==void 0).map(([t,e])=>[t,Zi(e)])),Kl=i=>Number.isFinite(Number(i))&&i.trim()!==""?Number(i):i,Li=Kl;var Hu=/^(\.|node_modules$|__MACOSX$)/,Gm={robot:"URDF",mujoco:"MJCF",sdf:"SDFormat"},Hm=/\.(urdf|xml|mjcf|sdf|world|toml|json)$/i,jl=/\.(urdf|xml|mjcf|sdf|world|config|toml|csv|json|sub)$/i,Gu=i=>i.replace(/.*\//,"");function Wu(i){return Array.from(i,e=>({path:e.webkitRelativePath||e.name,file:e})).filter(({path:e})=>!e.split("/").some(n=>Hu.test(n)))}async function Xu(i){let t=[...i.files].map(o=>({path:o.name,file:o})),e=[...i.items].filter(o=>o.kind==="file"),n=e.map(o=>o.webkitGetAsEntry?.()??null);if(!n.some(o=>o?.isDirectory))return t;let s=e.map(o=>o.getAsFileSystemHandle?.()),r=[];for(let[o,a]of n.entries()){let l=await s[o],c=l?$u(l):a&&qu(a);c&&await Yu(c,"",r)}return r}function $u(i){let{name:t}=i;return i.kind==="file"?{name:t,file:()=>i.getFile()}:{name:t,children:async()=>{let n=[];for await(let s of i.values())n.push($u(s));return n}}}function qu(i){let{name:t}=i;return i.isFile?{name:t,file:()=>new Promise((n,s)=>i.file(n,s))}:{name:t,children:async()=>{let n=i.createReader(),s=[];for(;;){let r=await new Promise((o,a)=>n.readEntries(o,a));if(!r.length)return s;s.push(...r.map(qu))}}}}async function Yu(i,t,e){if(Hu.test(i.name))return;if(e.length>=2e4)throw new Error("it has more than 20000 files; choose a folder below it");let n=t?`${t}/${i.name}`:i.name;i.file&&e.push({path:n,file:await i.file()});for(let s of await i.children?.()??[])await Yu(s,n,e)}function Wm(i,t){if(/\.toml$/i.test(i))return/^\s*template\s*=/m.test(t)?"suspension sheet":void 0;if(/\.json$/i.test(i))return/"Type"\s*:\s*"Suspension"/.test(t)?"Chrono::Vehicle":void 0;let e=/^\uFEFF?\s*(?:<\?[^>]*\?>\s*|<!--[^]*?-->\s*|<![^>]*>\s*)*<([A-Za-z]+)[\s>/]/.exec(t)?.[1];return e&&Gm[e]}function Xm(i){return new Set(i.split(/["'<>\n/\\]+/).map(t=>t.trim()))}async function Zu(i){let t=[];for(let{path:n,file:s}of i){if(!Hm.test(n)||s.size>33554432)continue;let r=await s.text(),o=Wm(n,r);o&&t.push({path:n,text:r,kind:o})}for(let n of t){let s=[...n.text.matchAll(/<include\b[^>]*\bfile\s*=\s*["']([^"']+)["']/g)].map(r=>Gu(r[1]));for(let r of t)r!==n&&s.includes(Gu(r.path))&&(r.within??=n.path)}let e=n=>n.within?1:0;return t.sort((n,s)=>e(n)-e(s)||n.path.localeCompare(s.path))}async function Ku(i,t){let e=new Map,n=[i.text];for(let a=n.pop();a!==void 0;a=n.pop()){let l=Xm(a);for(let{path:c,file:h}of t){if(c===i.path||e.has(c))continue;let f=c.split("/"),u=/\.(sdf|config)$/i.test(c)&&l.has(f.at(-2)??"");!l.has(f.at(-1))&&!u||(e.set(c,h),jl.test(c)&&h.size<=33554432&&n.push(await h.text()))}}let s={},r=[],o=i.text.length;for(let[a,l]of[...e].sort(([c,h],[f,u])=>Number(jl.test(f))-Number(jl.test(c))||h.size-u.size))o+=l.size,o>67108864?r.push(a):s[a]=await $m(l);return{model:{name:i.path,text:i.text,...Object.keys(s).length?{files:s}:{}},left:r}}function $m(i){return new Promise((t,e)=>{let n=new FileReader;n.onload=()=>t(n.result.split(",")[1]??""),n.onerror=()=>e(new Error(`${i.name}: ${n.error?.message??"cannot be read"}`)),n.readAsDataURL(i)})}function Jt(i,t=5){if(i===0)return"0";let e=Math.floor(Math.log10(Math.abs(i)));return e<-4||e>6?ju(i.toExponential(Math.max(0,t-1))):i.toFixed(Math.min(12,Math.max(0,t-1-e)))}function Nn(i,t,e=5){let n=t&&t>0?Math.floor(Math.log10(Math.abs(i)/t)):e;return Jt(i,Math.min(e,Math.max(1,n)))}var Xt=i=>i.replaceAll("_"," ");function Ju(i){return ju(i.toExponential(0))}function ju(i){let[t,e]=i.split("e");if(!e)return i;let n=String(Number(e)).replace(/./g,s=>s==="-"?"⁻":"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(s)]);return`${t}·10${n}`}function Ot(i,t){let e=i.toFixed(t);return(Number(e)===0?e.replace("-",""):e).replace("-","−")}function De(i,t){let e=Ot(i,t);return e.startsWith("−")||Number(e)===0?e:`+${e}`}function rn(i){return String(Number(i.toPrecision(12))+0)}var Ql={name:"mm",perSi:1e3,decimals:1,step:.5},tc={name:"°",perSi:180/Math.PI,decimals:1,step:.5};function ec(i){let t=/^\s*([-+0-9.eE]+)\s*(mm|cm|m|deg|rad)?\s*$/.exec(i);if(!t)return NaN;let e={mm:.001,cm:.01,m:1,deg:Math.PI/180,rad:1};return Number(t[1])*(t[2]?e[t[2]]:1)}function nc(i,t,e){let n=(t-i)/Math.max(1,e);if(!(n>0)||!Number.isFinite(n))return[i];let s=10**Math.floor(Math.log10(n)),r=h=>Math.floor(t/h+1e-9)-Math.ceil(i/h-1e-9)+1,o=[.5,1,2,5,10].map(h=>h*s),a=o.findIndex(h=>h>=n*.999),l=o.slice(0,a+1).findLast(h=>r(h)>=2)??o[0],c=[];for(let h=Math.ceil(i/l-1e-9);h*l<=t+1e-9*l;h++)c.push(Number((h*l).toPrecision(12)));return c}var td="rack",qm={"wheel-travel":"wheel travel",heave:"heave",roll:"roll"},Qu=.05,ic=Math.PI,Ym=.1,ed=.3,Ws=.005,Zm=1e-6,rc=/_(left|right)$/;function Xs(i){let t=i.flatMap(({kind:e,report:n,name:s})=>{let r=e==="stop"&&n?.named_contact?.brought_to_touch?n.named_contact.wheel_travel.map(a=>a.travel):[],o=r.reduce((a,l)=>a+l,0)/r.length;return Math.abs(o)<=ed?[{name:s.replace(rc,""),travel:o}]:[]});return t.filter((e,n)=>t.findIndex(s=>s.name===e.name&&Math.abs(s.travel-e.travel)<Zm)===n)}function Km(i,t){let e=[0,...Xs(i).map(o=>o.travel),Math.abs(t)<=ed?t:0],[n,s]=[Math.min(...e),Math.max(...e)],r=Math.max(.1*(s-n),Ws);return[n<0?Math.floor((n-r)/Ws)*Ws:-Qu,s>0?Math.ceil((s+r)/Ws)*Ws:Qu]}function Jm(i,t){let e=i.kind==="revolute"||i.kind==="continuous";if(!i.can_be_set||!(e||i.kind==="prismatic"))return null;let n=e?tc:Ql,s=e?ic:Ym,[r,o]=i.limits??[-s,s],a=[Math.max(r,-2*Math.max(s,ic)),Math.min(o,2*Math.max(s,ic))];return a[0]<a[1]?{name:i.name,label:i.name===td?`rack, + ${t?"left":"right"}`:i.name,isMotion:!1,unit:n,range:a}:null}function oc(i,t,e=0){let n=i.motions.map(o=>{let a=Km(t,e),l=Math.min(-a[0],a[1]);return{name:o,label:qm[o]??o,isMotion:!0,unit:Ql,range:o==="roll"?[-l,l]:a}}),s=({child:o,axis:a})=>[0,1,2].reduce((l,c)=>l+i.design[12*o+3+c]*(a?.[c]??0),0),r=i.joints.map(o=>Jm(o,s(o)>0)).filter(o=>o!==null);return n.length?[...n,...r.filter(o=>o.name===td)]:r}var jm=1e-9;function Qm(i,{axis:t,child:e,kind:n},s,r){if(n==="prismatic"||!t)return!1;let o=(c,h,f)=>[0,1,2].reduce((u,d)=>u+i.design[12*c+3*f+d]*h[d],0),[a,l]=[[0,1,2].map(c=>o(e,t,c)),[0,1,2].map(c=>o(s,r,c)+i.design[12*s+9+c]-i.design[12*e+9+c])];return Math.hypot(a[1]*l[2]-a[2]*l[1],a[2]*l[0]-a[0]*l[2],a[0]*l[1]-a[1]*l[0])<jm}function nd(i,t,e,n=[0,0,0]){if(t[0]?.isMotion)return t[0];let s=i.links.findIndex(a=>a.name===e),[r,o]=[s,void 0];for(let a=i.links.length;a>0;a--){let l=i.joints.find(h=>h.child===r);if(!l)break;let c=t.find(h=>h.name===l.name);if(c&&!Qm(i,l,s,n))return c;o??=c,r=l.parent}return o??t[0]}function ac(i,t){if(!t.isMotion){let n=i.pose.set?.[t.name];return n===void 0?void 0:ec(n)}let e=i.pose.travel?.find(n=>n.startsWith(`${t.name}=`));return e===void 0?void 0:ec(e.slice(t.name.length+1))}function id(i,t,e){let n=ac(t,i);if(n!==void 0)return n;if(!i.isMotion)return e?.report.pose[i.name]?.[0]??0;let s=e?.report.named_contact?.wheel_travel.map(({travel:r})=>r)??[];return!s.length||t.pose.travel?.length||i.name==="roll"?0:s.reduce((r,o)=>r+o,0)/s.length}function sd(i,t,e){if(e===i.root)return[];if(t[0]?.isMotion)return[t[0]];let n=[],s=e;for(let r=i.links.length;r>0;r--){let o=i.joints.find(l=>l.child===s);if(!o)break;let a=t.find(l=>l.name===o.name);a&&n.push(a),s=o.parent}return[...n,...t.filter(r=>!n.includes(r))]}function sc(i,t){return rn(Number((i*t.perSi).toFixed(6)))+(t===tc?"deg":t.name)}function on(i,t,e){if(t.isMotion){let s=(i.pose.travel??[]).filter(o=>!o.startsWith(`${t.name}=`)),r=e===void 0?s:[...s,`${t.name}=${sc(e,t.unit)}`];return{...i,pose:{...i.pose,travel:r}}}let n={...i.pose.set};return e===void 0?delete n[t.name]:n[t.name]=sc(e,t.unit),{...i,pose:{...i.pose,set:n}}}function Ki(i,t,e=!1){let n=i.range.map(o=>sc(o,i.unit)),[s,r]=e?n.reverse():n;return`${i.name}=${s}:${r}:${t}`}function rd(i,t,e){if(!e)return[{text:Ki(i,t),downwards:!1}];let[n,s]=i.range,r=(s-n)/(t-1),o=Math.ceil(-n/r-1e-9),a=(l,c,h)=>({text:Ki({...i,range:l},c,h),downwards:h});return o<2?[a([n,s],t,!1)]:o>t-2?[a([n,s],t,!0)]:[a([n+o*r,s],t-o,!1),a([n,n+(o-1)*r],o,!0)]}var lc=i=>i.status!=="unreachable"&&i.status!=="no answer";function cc(i,t){let e=i.reduce((r,o,a)=>lc(o)&&(r<0||Math.abs(o.at-t)<Math.abs(i[r].at-t))?a:r,-1);if(e<0)return;let[n,s]=[e,e];for(;n>0&&lc(i[n-1]);)n--;for(;s+1<i.length&&lc(i[s+1]);)s++;return[n,s]}function hc(i,t){let e=cc(i,t);if(!e)return[];let[n,s]=e,r=[];return n>0&&r.push({side:"lower",inside:i[n].at,outside:i[n-1].at}),s+1<i.length&&r.push({side:"upper",inside:i[s].at,outside:i[s+1].at}),r}var $s=(i,t)=>`${Ot(t*i.unit.perSi,i.unit.decimals+1)} ${i.unit.name}`;function od(i,t,e){let n=e.map(({side:o,inside:a})=>`The linkage ends at ${$s(t,a)} of ${t.label}: a dead centre, beyond which the loops do not close. It is the ${o} end.`),s=(o,a)=>{let l=[];i.rows.forEach((h,f)=>{h.status===o&&(f>0&&i.rows[f-1].status===o?l.at(-1)[1]=h.at:l.push([h.at,h.at]))});let c=l.map(([h,f])=>h===f?`at ${$s(t,h)}`:`from ${$s(t,h)} to ${$s(t,f)}`);c.length&&n.push(`${a} ${c.join(", ")}.`)};s("immovable","Immovable"),s("massless","Massless");let r=i.rows.filter(o=>o.singular).map(o=>$s(t,o.at));return r.length&&n.push(`Change points (dashed), at which branches cross and m̄ depends on the branch: ${r.slice(0,4).join(", ")}.`),n}function ad(i,t){let e=[],n=!1;for(let s of i){let r=s.mass!==null&&s.mass>=t[0]&&s.mass<=t[1];r&&n?e.at(-1)[1]=s.at:r&&e.push([s.at,s.at]),n=r}return e}async function ld(i,t){let e=new Blob([i]).stream().pipeThrough(t);return new Uint8Array(await new Response(e).arrayBuffer())}async function Ji(i){let e=Object.values(i.files??{}).reduce((r,o)=>r+o.length,i.text.length)>6e4?{...i,text:void 0,files:void 0}:i,n=await ld(new TextEncoder().encode(JSON.stringify(e)),new CompressionStream("deflate-raw"));return`#1:${btoa(Array.from(n,r=>String.fromCharCode(r)).join("")).replaceAll("+","-").replaceAll("/","_").replaceAll("=","")}`}async function cd(i){if(i.length<2)return null;let[t,e]=[i.slice(1,i.indexOf(":")),i.slice(i.indexOf(":")+1)];if(!i.includes(":")||t!=="1")throw new Error(`the link is of another version of this page (${t.slice(0,8)})`);try{let n=Uint8Array.from(atob(e.replaceAll("-","+").replaceAll("_","/")),r=>r.charCodeAt(0)),s=JSON.parse(new TextDecoder().decode(await ld(n,new DecompressionStream("deflate-raw"))));if(typeof s?.study?.model?.path!="string")throw new Error;return s}catch{throw new Error("the link is damaged: a part of it is missing")}}var ho=i=>[..."ABCDEFGH"].find(t=>!i.some(e=>e.name===t))??"A";function hd(i){return Array.from({length:8},(t,e)=>e).find(t=>!i.some(e=>e.colour===t))??0}function uc({model:i,pose:{travel:t,...e},conditions:n,hold:s}){return JSON.stringify([i,e,n,s])}var fc=81,eg=33,ng=21,ig=2,sg=9,rg=250,ud=300,og=300,ag=200,lg=400,uo=i=>"ok"in i?i.ok.rows:void 0,dc=class{engine;failure;notice;busy=!1;fileName="";text="";files;folder;shapes;opened;refusal;scene;study;answered;posed;problem;frames;curve;explanation;explained;contacts=[];listed="";listedAt=0;curvedAt=0;drivers=[];driver;variants=[];view="3d";colours="share";showsPoints=!0;showsNames=!0;hidesHints=!1;showsMotion=!1;showsDesign=!1;selected;choosing=!1;movedAtOpening={};past=[];future=[];target;tolerance;variation;ends=[];resting=Promise.resolve();answers=new co(t=>this.ask(t),()=>({study:this.problem?void 0:this.study,state:this.state()}),()=>this.changed());gesture;dirty=!1;working=!1;rest;times=[];listeners=new Set;listen(t){return this.listeners.add(t),()=>this.listeners.delete(t)}changed(){for(let t of this.listeners)t()}set(t){Object.assign(this,t),this.changed()}async start(t){try{this.engine=await ao.start()}catch(s){this.set({failure:`This browser does not run the engine (WebAssembly): ${String(s)}`});return}let e=null;try{e=await cd(location.hash)}catch(s){this.notice=s.message}let n=e?.text??(e?.study.model.path===t.model?.name?t.model?.text:void 0);if(e&&n===void 0&&(this.notice=`The link belongs to a page with ${e.study.model.path}.`),e&&n!==void 0){let s=n===t.model?.text?t.model:void 0,{files:r=s?.files,driver:o,study:a}=e;await this.open({name:a.model.path,text:n,files:r,shapes:s?.shapes},a,o),s&&this.answers.begin(t.study?.panels),Object.assign(this,{view:e.view??this.view,hidesHints:e.hidesHints??!1}),this.answers.turnTo(e.tab)}else t.model&&(await this.open(t.model,t.study,t.driver),this.answers.begin(t.study?.panels),t.view&&(this.view=t.view),await this.freezeAll(t.variants??[]));this.changed()}async freezeAll(t){let e=this.study;if(e){for(let{name:n,...s}of t.slice(0,8))this.study={...e,...s,model:{...e.model,...s.model,path:e.model.path}},await this.update(),this.freeze(n);this.study=e,await this.update()}}async openFolder(t){this.set({notice:void 0,folder:void 0});let e=await Zu(t);e.length?e.length===1?await this.openFromFolder(e[0],t):this.set({folder:{models:e,files:t}}):this.set({notice:`None of the ${t.length} files of the folder is a model: expected URDF, MJCF, SDFormat or a suspension sheet.`})}async openFromFolder(t,e){this.set({folder:void 0});let{model:n,left:s}=await Ku(t,e);await this.open(n),s.length&&this.set({notice:`${s.length===1?"1 file is":`${s.length} files are`} left out (the page reads at most 64 MiB): ${s.slice(0,3).join(", ")}${s.length>3?" …":""}`})}async open({name:t,text:e,files:n,shapes:s},r,o){let a={...r?.model,path:t},l=await this.ask({do:"open",model:a,text:e,files:n,shapes:!s});if(!l)return;if("refused"in l){this.set({refusal:l.refused,...this.opened?{}:{fileName:t,text:e,files:n}});return}let c=l.ok,h=r?.contact&&Object.values(r.contact).some(m=>m!==!1),f={model:a,contact:h?r.contact:c.contact,pose:r?.pose??{},conditions:r?.conditions&&Object.keys(r.conditions).length>0?r.conditions:c.conditions,...r?.hold?.length?{hold:r.hold}:{}},u=c.contacts?.contacts??[],d=oc(c.scene,u),g=f.contact.link??c.scene.links[c.scene.contacts.find(m=>m.name===f.contact.at)?.link??-1]?.name;Object.assign(this,{fileName:t,text:e,files:n,shapes:s??c.shapes?.links,opened:c,refusal:void 0,scene:c.scene,study:f,posed:void 0,problem:void 0,frames:c.scene.design,contacts:u,listed:"",curve:void 0,explanation:void 0,explained:void 0,drivers:d,driver:d.find(m=>m.name===o)??nd(c.scene,d,g,f.contact.point),view:c.scene.sheet?"front":"3d",choosing:!1,variants:[],ends:[],variation:void 0,past:[],future:[],selected:void 0,movedAtOpening:a.move??{}}),this.answers.clear();let x=c.shapes?.diagnostics.length;x&&(this.notice=`${x} ${x===1?"link is":"links are"} drawn without ${x===1?"its shape":"their shapes"} (see Findings). Meshes are found in a folder with the model: choose it by Folder…, or drop it.`),await this.update()}async ask(t){let e=setTimeout(()=>this.set({busy:!0}),og);try{return await this.engine.ask(t)}catch(n){n instanceof Hs||(this.notice=`The engine stopped: ${n.message}. The page goes on with a new one.`,await this.engine.end(),await this.reopen());return}finally{clearTimeout(e),this.busy=!1}}reopen(){return this.engine.ask({do:"open",model:{path:this.fileName},text:this.text,files:this.files})}async end(){!this.busy||!this.engine||!this.study||(await this.engine.end(),await this.reopen(),this.set({busy:!1,notice:"The work was ended. The last result is shown."}))}async update(){if(this.dirty=!0,!this.working){for(this.working=!0;this.dirty&&this.study;){this.dirty=!1;let t=this.study,e=performance.now(),n=await this.ask({do:"show",question:t});if(!n)break;if(this.times.push(performance.now()-e),this.times.length>lg&&this.times.shift(),"refused"in n)this.problem=n.refused;else{let{scene:s,result:r,frames:o}=n.ok;s&&(this.scene=s),"ok"in r?(this.posed=r.ok,this.frames=r.ok.frames,this.problem=void 0,this.answered=t):(this.problem=r.refused,this.frames=o??this.frames)}if(this.changed(),(!this.gesture||!this.dirty||performance.now()-this.curvedAt>ud)&&!await this.drawCurve(t))break;!this.dirty&&(!this.gesture||performance.now()-this.listedAt>ud)&&await this.listContacts(t),!this.dirty&&!this.gesture&&this.fitRange()&&(this.dirty=!0)}this.working=!1,clearTimeout(this.rest),this.rest=setTimeout(()=>{this.rest=void 0,this.resting=this.atRest()},rg),this.changed()}}async drawCurve(t){let{driver:e}=this,n;for(let{text:s,downwards:r}of e?rd(e,this.gesture?eg:fc,!!this.scene?.closures.length):[]){let o=await this.ask({do:"curve",question:t,vary:s});if(!o)return!1;r&&uo(o)?.reverse(),n?uo(n)?.unshift(...uo(o)??[]):n=o}return this.curvedAt=performance.now(),this.curve=n,this.ends=this.rows?hc(this.rows,e?this.positionOf(e):0):[],this.variation=void 0,this.changed(),!0}async atRest(){if(!(!this.study||this.working)){if(this.gesture)return this.listContacts(this.study);await this.writeHash(),await this.refineEnds(),await this.answers.refresh(),await this.varyPoints(),await this.explain()}}async rested(){let t=()=>this.isIdle&&this.rest===void 0&&(this.problem!==void 0||this.answers.isFresh());for(;!t();)await new Promise(e=>setTimeout(e,20));await this.resting}get rows(){return this.curve&&uo(this.curve)}async refineEnds(){let{study:t,driver:e}=this,n=e&&this.positionOf(e);for(let s of this.ends)for(let r=0;r<ig;r++){let o=Math.min(s.inside,s.outside),a=Math.max(s.inside,s.outside),l=s.side==="lower",c=await this.ask({do:"curve",question:t,vary:Ki({...e,range:[o,a]},ng,l)});if(this.study!==t||this.driver!==e||!c||!("ok"in c))return;let h=c.ok.rows,[f]=hc(l?h.reverse():h,s.inside);if(!f||n===void 0)break;Object.assign(s,{inside:f.inside,outside:f.outside})}this.ends.length&&this.set({ends:[...this.ends]})}async varyPoints(){let{study:t,driver:e,tolerance:n,rows:s}=this;if(!n||!e||!s||!this.scene?.sheet)return;let r=s.filter(l=>l.mass!==null),o=Math.min(sg,r.length),a=[];for(let l=0;l<o;l++){let c=r[Math.round(l*(r.length-1)/Math.max(1,o-1))],h=await this.ask({do:"explain",question:on(t,e,c.at)});if(this.study!==t||this.tolerance!==n||this.driver!==e)return;if(!h||!("ok"in h)||!h.ok)continue;let f=h.ok.points.flatMap(u=>u.per_metre??[]).map(u=>Math.abs(u)*n);a.push({at:c.at,mass:c.mass,rss:Math.hypot(...f),worst:f.reduce((u,d)=>u+d,0)})}this.set({variation:a})}setTolerance(t){this.set({tolerance:t,variation:void 0}),this.resting=this.resting.then(()=>this.varyPoints())}positionOf(t){return this.study?id(t,this.study,this.posed):0}state(){let t=this.drivers.filter(e=>e.isMotion||e.name==="rack");return Object.fromEntries(t.map(e=>[e.isMotion?e.name:"steer",this.positionOf(e)]).filter(([,e])=>e!==0))}async framesAt(t,e){let n=await this.ask({do:"show",question:on(this.study,t,e)});if(!(!n||!("ok"in n)))return"ok"in n.ok.result?n.ok.result.ok.frames:n.ok.frames??void 0}async writeHash(){if(!this.study||this.gesture)return;let t=await Ji(this.linked());history.replaceState(null,"",t)}linked(){return{study:this.study,text:this.text,files:this.files,driver:this.driver?.name,view:this.view,tab:this.answers.tab,hidesHints:this.hidesHints}}async explain(){let{study:t}=this;if(this.problem||this.explained===t)return;let e=await this.ask({do:"explain",question:t});this.study!==t||this.gesture||!e||!("ok"in e)||this.set({explanation:e.ok,explained:t})}get contactsAreFresh(){return!!this.study&&this.listed===uc(this.study)}async listContacts(t){if(!this.scene?.contacts.length||this.problem||this.contactsAreFresh)return;this.listedAt=performance.now();let e=await this.ask({do:"contacts",question:{...t,contact:{},pose:{...t.pose,travel:[]}}});e&&"ok"in e&&this.set({contacts:e.ok.contacts,listed:uc(t)})}fitRange(){let t=oc(this.scene,this.contacts,this.drivers[0]?.isMotion&&!this.problem?this.positionOf(this.drivers[0]):0);if(JSON.stringify(t)===JSON.stringify(this.drivers))return!1;this.drivers=t;let e=this.driver;return this.driver=t.find(n=>n.name===e?.name),JSON.stringify(e)!==JSON.stringify(this.driver)}async solve(t,e,n){let{study:s}=this,r=await this.ask({do:"solve",question:s,unknown:t,mass:e,within:n});if(!r||this.study!==s)return"The search was ended.";if("refused"in r)return r.refused.message;let{is_reached:o,moves:[a],link_masses:[l]}=r.ok,c=`${t} for ${e} kg`;return o&&a&&this.movePoint(a[0],this.moved(a[0]).map((h,f)=>h+a[1][f]),c),o&&l&&this.change({...s,model:{...s.model,link_mass:{...s.model.link_mass,[l[0]]:l[1]}}},c),r.ok}async sheetText(){let t=await this.ask({do:"sheet",model:this.study.model});if(t&&"ok"in t)return t.ok;t&&this.set({notice:t.refused.message})}begin(t){this.gesture??={study:this.study,label:t}}finish(t=!0,e){let n=this.gesture;this.gesture=void 0,n&&(t?n.study!==this.study&&(this.past=[...this.past,{study:n.study,label:e??n.label}].slice(-ag),this.future=[]):this.study=n.study,this.update(),this.changed())}get isIdle(){return this.opened!==void 0&&!this.working&&!this.gesture}async finishAnswered(t,e){for(;this.working;)await new Promise(n=>setTimeout(n,4));this.finish(t&&!this.problem,e)}get lastLabel(){return this.gesture?.label??this.past.at(-1)?.label}get inGesture(){return this.gesture!==void 0}change(t,e){let n=!this.gesture;if(n&&this.begin(e),this.study=t,!n){this.update();return}this.finish(),this.changed()}undo(){let t=this.past.at(-1);!t||this.gesture||(this.past=this.past.slice(0,-1),this.future=[...this.future,{study:this.study,label:t.label}],this.study=t.study,this.update(),this.changed())}redo(){let t=this.future.at(-1);!t||this.gesture||(this.future=this.future.slice(0,-1),this.past=[...this.past,{study:this.study,label:t.label}],this.study=t.study,this.update(),this.changed())}chooseDriver(t){this.driver=this.drivers.find(e=>e.name===t)??this.driver,this.variants=this.variants.map(e=>e.driver===t?e:{...e,curve:null,driver:t}),this.update(),this.changed()}freeze(t){if(!this.posed||!this.study||!this.scene||this.problem)return;let e=t??ho(this.variants),n=this.curve&&"ok"in this.curve?this.curve.ok:null,s=this.variants.filter(a=>a.name!==e),r={name:e,colour:hd(s),study:this.study,mass:this.posed.report.effective_mass,curve:n,driver:this.driver?.name??"",scene:this.scene,frames:this.posed.frames},o=this.answers.results.kinematics;o&&"ok"in o&&this.answers.isFresh()&&(r.kinematics=o.ok),this.set({variants:[...s,r]})}moved(t){return this.study?.model.move?.[t]??[0,0,0]}movePoint(t,e,n){let s=this.study,r={...s.model.move},o=e.map(l=>Math.round(l*1e7)/1e7+0);o.every(l=>l===0)?delete r[t]:r[t]=o;let a={...s.model,move:r};Object.keys(r).length===0&&delete a.move,this.change({...s,model:a},n)}setContact(t,e){this.change({...this.study,contact:t},e)}ownContact(){let t=this.study?.contact;if(t&&!t.at&&!t.along_line&&!t.frame)return t;let e=this.posed?.report.contact;if(!e)return;let n=(s,r)=>s.map(o=>Math.round(o*r)/r+0);return{link:e.link,point:n(e.point_link,1e5),normal:n(e.normal_link,1e6),...e.against?{against:e.against}:{}}}get axes(){return this.scene?.sheet?.hardpoints[0]?.to_world??[1,1,1]}get findings(){let t=this.opened?.shapes?.diagnostics??[];return[...this.posed?.report.diagnostics??this.opened?.diagnostics??[],...t]}},E=new dc;var dd=i=>/^[A-Za-z0-9_\-+.,:=/%@]+$/.test(i)?i:`'${i.replaceAll("'","'\\''")}'`,ai=i=>i.map(rn).join(",");function po(){let i=[];return{out:i,one:(e,n)=>{n!==void 0&&n!==""&&i.push([e,String(n)])}}}function fo({model:i}){let{out:t,one:e}=po();for(let[n,s]of Object.entries(i.move??{}))e("--move",`${n}=${ai(s)}`);for(let[n,s]of Object.entries(i.link_mass??{}))e("--link-mass",`${n}=${rn(s)}`);for(let[n,s]of Object.entries(i.link_inertia??{}))e("--link-inertia",`${n}=${ai(s)}`);for(let[n,s]of Object.entries(i.link_com??{}))e("--link-com",`${n}=${ai(s)}`);return t}function fd({contact:i}){let{out:t,one:e}=po();return e("--at",i.at),e("--link",i.link),i.point&&e("--point",ai(i.point)),i.normal&&e("--normal",ai(i.normal)),i.along_line&&e("--along-line",`${i.along_line.link}:${ai(i.along_line.point)}`),i.turning_normal&&t.push(["--turning-normal"]),i.cable&&t.push(["--cable"]),e("--frame",i.frame),e("--normal-frame",i.normal_frame),e("--against",i.against),e("--against-mass",i.against_mass),t}function pc({pose:i,conditions:t,hold:e}){let{out:n,one:s}=po();s("--pose",i.file);for(let[r,o]of Object.entries(i.set??{}))s("--set",`${r}=${o}`);for(let[r,o]of Object.entries(i.guess??{}))s("--guess",`${r}=${o}`);for(let r of i.travel??[]){let o=/^(wheel-travel|heave|roll)=(.*)$/.exec(r);o?s(`--${o[1]}`,o[2]):s("--travel",r)}for(let r of t.lock??[])s("--lock",r);for(let[r,o]of Object.entries(t.armature??{}))s("--armature",`${r}=${[o].flat().map(rn).join(",")}`);for(let[r,o]of Object.entries(t.gear_stiffness??{}))s("--gear-stiffness",`${r}=${[o].flat().map(a=>typeof a=="number"?rn(a):a).join(",")}`);s("--base",t.base);for(let r of e??[])s("--hold",`${r.link}:${ai(r.point)}${r.normal?`:${ai(r.normal)}`:""}`);return n}function qs(i,t,e){let n=e.map(([s,r])=>r===void 0?s:`${s}=${dd(r)}`);return[`percuss ${i} ${dd(t.model.path)}`,...n].join(` \\
    `)}function pd(i){return qs("mass",i,[...fo(i),...fd(i),...pc(i)])}function mo(i,t,e){let n=[...fo(t),...fd(t),...pc(t)],{out:s,one:r}=po();switch(i){case"damper":r("--limit",e.stop),r("--restitution",e.restitution.trim()),r("--stiffness",e.stiffness.trim()),r("--speed",e.speed.trim()),r("--law",e.law),r("--for",e.tool);for(let[o,a]of Object.entries(e.further))r(`--${o.replaceAll("_","-")}`,String(a));return qs("damp --mass-from",t,[...e.stop?[...fo(t),...pc(t)]:n,...s]);case"impact":return r("--restitution",e.impactRestitution.trim()),r("--speed",e.impactSpeed.trim()||"1 m/s"),r("--stiffness",e.impactStiffness.trim()),e.impactInTime&&s.push(["--in-time"]),qs("impact",t,[...n,...s]);case"safe":return r("--region",e.region),r(`--${e.limit}`,e.limitValue.trim()),e.limit==="pressure"&&r("--area",e.area.trim()),r("--load",e.load.trim()),qs("safe-speed",t,[...n,...s])}}function md(i,t){let e=Object.entries(t).map(([n,s])=>[`--${n}`,rn(s)]);return qs("kinematics",i,[...fo(i),...e])}var mc=i=>Array.isArray(i)?`[${i.map(mc).join(", ")}]`:typeof i=="number"?rn(i):typeof i=="object"&&i!==null?`{ ${Object.entries(i).map(([t,e])=>`${gd(t)} = ${mc(e)}`).join(", ")} }`:JSON.stringify(i),gd=i=>/^[A-Za-z0-9_-]+$/.test(i)?i:JSON.stringify(i);function ji(i,t){let e=Object.entries(t).filter(([,n])=>n==null||n===!1?!1:!(typeof n=="object"&&Object.keys(n).length===0));return e.length?`${i}
${e.map(([n,s])=>`${gd(n)} = ${mc(s)}`).join(`
`)}
`:""}function gc(i,t){return[ji("[model]",i.model),ji("[contact]",i.contact),ji("[pose]",i.pose),ji("[conditions]",i.conditions),...(i.hold??[]).map(e=>ji("[[hold]]",e)),t?ji("[sweep]",{vary:t,output:"curve.csv"}):""].filter(Boolean).join(`
`)}function _d(i){return["import pathlib, percuss",`pathlib.Path("study.toml").write_text("""${gc(i,void 0).replaceAll("\\","\\\\")}""")`,'report = percuss.run_study("study.toml")','print(report["effective_mass"])'].join(`
`)}function Zt(){let[,i]=ql((t,e)=>t+1,0);return Qe(()=>E.listen(()=>i()),[]),E}var Si={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Mi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},jd=0,Kc=1,Qd=2;var Rr=1,tf=2,Rs=3,wi=0,Je=1,pn=2,Bi=0,Ps=1,Jc=2,jc=3,Qc=4,ef=5;var zi=100,nf=101,sf=102,rf=103,of=104,af=200,lf=201,cf=202,hf=203,th=204,eh=205,uf=206,df=207,ff=208,pf=209,mf=210,gf=211,_f=212,xf=213,yf=214,Vo=0,Go=1,Ho=2,ms=3,Wo=4,Xo=5,$o=6,qo=7,Ca=0,vf=1,bf=2,Bn=0,nh=1,ih=2,sh=3,rh=4,oh=5,ah=6,lh=7;var ch=300,Vi=301,Is=302,Ra=303,Pa=304,Yo=1e3,Un=1001,Zo=1002,Oe=1003,Sf=1004;var Pr=1005;var Ke=1006,Ia=1007;var Qn=1008;var en=1009,hh=1010,uh=1011,Ls=1012,La=1013,Rn=1014,Pn=1015,In=1016,Da=1017,Na=1018,Gi=1020,dh=35902,fh=35899,ph=1021,mh=1022,Ln=1023,Zn=1026,ti=1027,gh=1028,Oa=1029,Ti=1030,Ua=1031;var Fa=1033,Ir=33776,Lr=33777,Dr=33778,Nr=33779,ka=35840,Ba=35841,za=35842,Va=35843,Ga=36196,Ha=37492,Wa=37496,Xa=37488,$a=37489,Or=37490,qa=37491,Ya=37808,Za=37809,Ka=37810,Ja=37811,ja=37812,Qa=37813,tl=37814,el=37815,nl=37816,il=37817,sl=37818,rl=37819,ol=37820,al=37821,ll=36492,cl=36494,hl=36495,ul=36283,dl=36284,Ur=36285,fl=36286;var sr=2300,Ko=2301,Bo=2302,Gc=2303,Hc=2400,Wc=2401,Xc=2402;var Mf=3200;var pl=0,wf=1,ei="",cn="srgb",rr="srgb-linear",or="linear",ie="srgb";var zo=7680;var Tf=519,Ef=512,Af=513,Cf=514,_h=515,Rf=516,Pf=517,xh=518,yh=519,If=35044;var vh="300 es",bn=2e3,gs=2001;function cg(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function hg(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ar(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Lf(){let i=ar("canvas");return i.style.display="block",i}var xd={},_s=null;function bh(...i){let t="THREE."+i.shift();_s?_s("log",t,...i):console.log(t,...i)}function Df(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Pt(...i){i=Df(i);let t="THREE."+i.shift();if(_s)_s("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Nt(...i){i=Df(i);let t="THREE."+i.shift();if(_s)_s("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Qs(...i){let t=i.join(" ");t in xd||(xd[t]=!0,Pt(...i))}function Nf(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Of={[Vo]:Vo,[Ho]:$o,[Wo]:Wo,[ms]:Xo,[Go]:Go,[$o]:Ho,[qo]:qo,[Xo]:ms},Cn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},We=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],yd=1234567,tr=Math.PI/180,xs=180/Math.PI;function Ds(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(We[i&255]+We[i>>8&255]+We[i>>16&255]+We[i>>24&255]+"-"+We[t&255]+We[t>>8&255]+"-"+We[t>>16&15|64]+We[t>>24&255]+"-"+We[e&63|128]+We[e>>8&255]+"-"+We[e>>16&255]+We[e>>24&255]+We[n&255]+We[n>>8&255]+We[n>>16&255]+We[n>>24&255]).toLowerCase()}function Ut(i,t,e){return Math.max(t,Math.min(e,i))}function Sh(i,t){return(i%t+t)%t}function ug(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function dg(i,t,e){return i!==t?(e-i)/(t-i):0}function er(i,t,e){return(1-e)*i+e*t}function fg(i,t,e,n){return er(i,t,1-Math.exp(-e*n))}function pg(i,t=1){return t-Math.abs(Sh(i,t*2)-t)}function mg(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function gg(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function _g(i,t){return i+Math.floor(Math.random()*(t-i+1))}function xg(i,t){return i+Math.random()*(t-i)}function yg(i){return i*(.5-Math.random())}function vg(i){i!==void 0&&(yd=i);let t=yd+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function bg(i){return i*tr}function Sg(i){return i*xs}function Mg(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function wg(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Mh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Tg(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),f=r((t-n)/2),u=o((t-n)/2),d=r((n-t)/2),g=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*f,l*u,a*c);break;case"YZY":i.set(l*u,a*h,l*f,a*c);break;case"ZXZ":i.set(l*f,l*u,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*d,a*h,a*c);break;default:Pt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function wh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Uf(i,t){if(t.constructor===Float32Array)return i;let e=wh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Ff(i,t){if(t.constructor===Float32Array)return i;let e=wh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Th={DEG2RAD:tr,RAD2DEG:xs,generateUUID:Ds,clamp:Ut,euclideanModulo:Sh,mapLinear:ug,inverseLerp:dg,lerp:er,damp:fg,pingpong:pg,smoothstep:mg,smootherstep:gg,randInt:_g,randFloat:xg,randFloatSpread:yg,seededRandom:vg,degToRad:bg,radToDeg:Sg,isPowerOfTwo:Mg,ceilPowerOfTwo:wg,floorPowerOfTwo:Mh,setQuaternionFromProperEuler:Tg,normalize:Ff,denormalize:Uf},Mt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Ut(this.x,t.x,e.x),this.y=Ut(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Ut(this.x,t,e),this.y=Ut(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ut(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Ut(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ue=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],f=n[s+3],u=r[o+0],d=r[o+1],g=r[o+2],x=r[o+3];if(f!==x||l!==u||c!==d||h!==g){let m=l*u+c*d+h*g+f*x;m<0&&(u=-u,d=-d,g=-g,x=-x,m=-m);let _=1-a;if(m<.9995){let v=Math.acos(m),w=Math.sin(v);_=Math.sin(_*v)/w,a=Math.sin(a*v)/w,l=l*_+u*a,c=c*_+d*a,h=h*_+g*a,f=f*_+x*a}else{l=l*_+u*a,c=c*_+d*a,h=h*_+g*a,f=f*_+x*a;let v=1/Math.sqrt(l*l+c*c+h*h+f*f);l*=v,c*=v,h*=v,f*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=f}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],f=r[o],u=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+h*f+l*d-c*u,t[e+1]=l*g+h*u+c*f-a*d,t[e+2]=c*g+h*d+a*u-l*f,t[e+3]=h*g-a*f-l*u-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),f=a(r/2),u=l(n/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*f+c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f-u*d*g;break;case"YXZ":this._x=u*h*f+c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f+u*d*g;break;case"ZXY":this._x=u*h*f-c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f-u*d*g;break;case"ZYX":this._x=u*h*f-c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f+u*d*g;break;case"YZX":this._x=u*h*f+c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f-u*d*g;break;case"XZY":this._x=u*h*f-c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f+u*d*g;break;default:Pt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],f=e[10],u=n+a+f;if(u>0){let d=.5/Math.sqrt(u+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>f){let d=2*Math.sqrt(1+n-a-f);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-n-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+f-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Ut(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},R=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(vd.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(vd.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),f=2*(r*n-o*e);return this.x=e+l*c+o*f-a*h,this.y=n+l*h+a*c-r*f,this.z=s+l*f+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Ut(this.x,t.x,e.x),this.y=Ut(this.y,t.y,e.y),this.z=Ut(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Ut(this.x,t,e),this.y=Ut(this.y,t,e),this.z=Ut(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ut(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return _c.copy(this).projectOnVector(t),this.sub(_c)}reflect(t){return this.sub(_c.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Ut(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},_c=new R,vd=new Ue,Ft=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],f=n[7],u=n[2],d=n[5],g=n[8],x=s[0],m=s[3],_=s[6],v=s[1],w=s[4],M=s[7],P=s[2],C=s[5],y=s[8];return r[0]=o*x+a*v+l*P,r[3]=o*m+a*w+l*C,r[6]=o*_+a*M+l*y,r[1]=c*x+h*v+f*P,r[4]=c*m+h*w+f*C,r[7]=c*_+h*M+f*y,r[2]=u*x+d*v+g*P,r[5]=u*m+d*w+g*C,r[8]=u*_+d*M+g*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],f=h*o-a*c,u=a*l-h*r,d=c*r-o*l,g=e*f+n*u+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return t[0]=f*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=u*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=d*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Qs("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(xc.makeScale(t,e)),this}rotate(t){return Qs("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(xc.makeRotation(-t)),this}translate(t,e){return Qs("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(xc.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},xc=new Ft,bd=new Ft().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Sd=new Ft().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Eg(){let i={enabled:!0,workingColorSpace:rr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ie&&(s.r=Yn(s.r),s.g=Yn(s.g),s.b=Yn(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ie&&(s.r=ps(s.r),s.g=ps(s.g),s.b=ps(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ei?or:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[rr]:{primaries:t,whitePoint:n,transfer:or,toXYZ:bd,fromXYZ:Sd,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:cn},outputColorSpaceConfig:{drawingBufferColorSpace:cn}},[cn]:{primaries:t,whitePoint:n,transfer:ie,toXYZ:bd,fromXYZ:Sd,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:cn}}}),i}var Kt=Eg();function Yn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ps(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Qi,Jo=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Qi===void 0&&(Qi=ar("canvas")),Qi.width=t.width,Qi.height=t.height;let s=Qi.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Qi}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ar("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Yn(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Yn(e[n]/255)*255):e[n]=Yn(e[n]);return{data:e,width:t.width,height:t.height}}else return Pt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Ag=0,ys=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Ag++}),this.uuid=Ds(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(yc(s[o].image)):r.push(yc(s[o]))}else r=yc(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function yc(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Jo.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Pt("Texture: Unable to serialize Texture."),{})}var Cg=0,vc=new R,tn=class i extends Cn{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Un,s=Un,r=Ke,o=Qn,a=Ln,l=en,c=i.DEFAULT_ANISOTROPY,h=ei){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Cg++}),this.uuid=Ds(),this.name="",this.source=new ys(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Mt(0,0),this.repeat=new Mt(1,1),this.center=new Mt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ft,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(vc).x}get height(){return this.source.getSize(vc).y}get depth(){return this.source.getSize(vc).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Pt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Pt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==ch)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Yo:t.x=t.x-Math.floor(t.x);break;case Un:t.x=t.x<0?0:1;break;case Zo:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Yo:t.y=t.y-Math.floor(t.y);break;case Un:t.y=t.y<0?0:1;break;case Zo:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};tn.DEFAULT_IMAGE=null;tn.DEFAULT_MAPPING=ch;tn.DEFAULT_ANISOTROPY=1;var _e=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],f=l[8],u=l[1],d=l[5],g=l[9],x=l[2],m=l[6],_=l[10];if(Math.abs(h-u)<.01&&Math.abs(f-x)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(f+x)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+_-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,M=(d+1)/2,P=(_+1)/2,C=(h+u)/4,y=(f+x)/4,T=(g+m)/4;return w>M&&w>P?w<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(w),s=C/n,r=y/n):M>P?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=C/s,r=T/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=y/r,s=T/r),this.set(n,s,r,e),this}let v=Math.sqrt((m-g)*(m-g)+(f-x)*(f-x)+(u-h)*(u-h));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(f-x)/v,this.z=(u-h)/v,this.w=Math.acos((c+d+_-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Ut(this.x,t.x,e.x),this.y=Ut(this.y,t.y,e.y),this.z=Ut(this.z,t.z,e.z),this.w=Ut(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Ut(this.x,t,e),this.y=Ut(this.y,t,e),this.z=Ut(this.z,t,e),this.w=Ut(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ut(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},jo=class extends Cn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ke,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new _e(0,0,t,e),this.scissorTest=!1,this.viewport=new _e(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new tn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ke,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ys(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},dn=class extends jo{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},lr=class extends tn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Oe,this.minFilter=Oe,this.wrapR=Un,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Qo=class extends tn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Oe,this.minFilter=Oe,this.wrapR=Un,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Qt=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,f,u,d,g,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,f,u,d,g,x,m)}set(t,e,n,s,r,o,a,l,c,h,f,u,d,g,x,m){let _=this.elements;return _[0]=t,_[4]=e,_[8]=n,_[12]=s,_[1]=r,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=h,_[10]=f,_[14]=u,_[3]=d,_[7]=g,_[11]=x,_[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/ts.setFromMatrixColumn(t,0).length(),r=1/ts.setFromMatrixColumn(t,1).length(),o=1/ts.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let u=o*h,d=o*f,g=a*h,x=a*f;e[0]=l*h,e[4]=-l*f,e[8]=c,e[1]=d+g*c,e[5]=u-x*c,e[9]=-a*l,e[2]=x-u*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,d=l*f,g=c*h,x=c*f;e[0]=u+x*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*f,e[5]=o*h,e[9]=-a,e[2]=d*a-g,e[6]=x+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,d=l*f,g=c*h,x=c*f;e[0]=u-x*a,e[4]=-o*f,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*h,e[9]=x-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,d=o*f,g=a*h,x=a*f;e[0]=l*h,e[4]=g*c-d,e[8]=u*c+x,e[1]=l*f,e[5]=x*c+u,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,d=o*c,g=a*l,x=a*c;e[0]=l*h,e[4]=x-u*f,e[8]=g*f+d,e[1]=f,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*f+g,e[10]=u-x*f}else if(t.order==="XZY"){let u=o*l,d=o*c,g=a*l,x=a*c;e[0]=l*h,e[4]=-f,e[8]=c*h,e[1]=u*f+x,e[5]=o*h,e[9]=d*f-g,e[2]=g*f-d,e[6]=a*h,e[10]=x*f+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Rg,t,Pg)}lookAt(t,e,n){let s=this.elements;return an.subVectors(t,e),an.lengthSq()===0&&(an.z=1),an.normalize(),li.crossVectors(n,an),li.lengthSq()===0&&(Math.abs(n.z)===1?an.x+=1e-4:an.z+=1e-4,an.normalize(),li.crossVectors(n,an)),li.normalize(),go.crossVectors(an,li),s[0]=li.x,s[4]=go.x,s[8]=an.x,s[1]=li.y,s[5]=go.y,s[9]=an.y,s[2]=li.z,s[6]=go.z,s[10]=an.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],f=n[5],u=n[9],d=n[13],g=n[2],x=n[6],m=n[10],_=n[14],v=n[3],w=n[7],M=n[11],P=n[15],C=s[0],y=s[4],T=s[8],U=s[12],L=s[1],O=s[5],B=s[9],H=s[13],D=s[2],Y=s[6],J=s[10],X=s[14],nt=s[3],q=s[7],k=s[11],Z=s[15];return r[0]=o*C+a*L+l*D+c*nt,r[4]=o*y+a*O+l*Y+c*q,r[8]=o*T+a*B+l*J+c*k,r[12]=o*U+a*H+l*X+c*Z,r[1]=h*C+f*L+u*D+d*nt,r[5]=h*y+f*O+u*Y+d*q,r[9]=h*T+f*B+u*J+d*k,r[13]=h*U+f*H+u*X+d*Z,r[2]=g*C+x*L+m*D+_*nt,r[6]=g*y+x*O+m*Y+_*q,r[10]=g*T+x*B+m*J+_*k,r[14]=g*U+x*H+m*X+_*Z,r[3]=v*C+w*L+M*D+P*nt,r[7]=v*y+w*O+M*Y+P*q,r[11]=v*T+w*B+M*J+P*k,r[15]=v*U+w*H+M*X+P*Z,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],f=t[6],u=t[10],d=t[14],g=t[3],x=t[7],m=t[11],_=t[15],v=l*d-c*u,w=a*d-c*f,M=a*u-l*f,P=o*d-c*h,C=o*u-l*h,y=o*f-a*h;return e*(x*v-m*w+_*M)-n*(g*v-m*P+_*C)+s*(g*w-x*P+_*y)-r*(g*M-x*C+m*y)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],f=t[9],u=t[10],d=t[11],g=t[12],x=t[13],m=t[14],_=t[15],v=e*a-n*o,w=e*l-s*o,M=e*c-r*o,P=n*l-s*a,C=n*c-r*a,y=s*c-r*l,T=h*x-f*g,U=h*m-u*g,L=h*_-d*g,O=f*m-u*x,B=f*_-d*x,H=u*_-d*m,D=v*H-w*B+M*O+P*L-C*U+y*T;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let Y=1/D;return t[0]=(a*H-l*B+c*O)*Y,t[1]=(s*B-n*H-r*O)*Y,t[2]=(x*y-m*C+_*P)*Y,t[3]=(u*C-f*y-d*P)*Y,t[4]=(l*L-o*H-c*U)*Y,t[5]=(e*H-s*L+r*U)*Y,t[6]=(m*M-g*y-_*w)*Y,t[7]=(h*y-u*M+d*w)*Y,t[8]=(o*B-a*L+c*T)*Y,t[9]=(n*L-e*B-r*T)*Y,t[10]=(g*C-x*M+_*v)*Y,t[11]=(f*M-h*C-d*v)*Y,t[12]=(a*U-o*O-l*T)*Y,t[13]=(e*O-n*U+s*T)*Y,t[14]=(x*w-g*P-m*v)*Y,t[15]=(h*P-f*w+u*v)*Y,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,f=a+a,u=r*c,d=r*h,g=r*f,x=o*h,m=o*f,_=a*f,v=l*c,w=l*h,M=l*f,P=n.x,C=n.y,y=n.z;return s[0]=(1-(x+_))*P,s[1]=(d+M)*P,s[2]=(g-w)*P,s[3]=0,s[4]=(d-M)*C,s[5]=(1-(u+_))*C,s[6]=(m+v)*C,s[7]=0,s[8]=(g+w)*y,s[9]=(m-v)*y,s[10]=(1-(u+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=ts.set(s[0],s[1],s[2]).length(),a=ts.set(s[4],s[5],s[6]).length(),l=ts.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Tn.copy(this);let c=1/o,h=1/a,f=1/l;return Tn.elements[0]*=c,Tn.elements[1]*=c,Tn.elements[2]*=c,Tn.elements[4]*=h,Tn.elements[5]*=h,Tn.elements[6]*=h,Tn.elements[8]*=f,Tn.elements[9]*=f,Tn.elements[10]*=f,e.setFromRotationMatrix(Tn),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=bn,l=!1){let c=this.elements,h=2*r/(e-t),f=2*r/(n-s),u=(e+t)/(e-t),d=(n+s)/(n-s),g,x;if(l)g=r/(o-r),x=o*r/(o-r);else if(a===bn)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===gs)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=bn,l=!1){let c=this.elements,h=2/(e-t),f=2/(n-s),u=-(e+t)/(e-t),d=-(n+s)/(n-s),g,x;if(l)g=1/(o-r),x=o/(o-r);else if(a===bn)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===gs)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},ts=new R,Tn=new Qt,Rg=new R(0,0,0),Pg=new R(1,1,1),li=new R,go=new R,an=new R,Md=new Qt,wd=new Ue,Kn=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],f=s[2],u=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(Ut(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ut(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ut(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ut(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(u,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ut(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-Ut(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Pt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Md.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Md,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return wd.setFromEuler(this),this.setFromQuaternion(wd,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Kn.DEFAULT_ORDER="XYZ";var vs=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Ig=0,Td=new R,es=new Ue,Hn=new Qt,_o=new R,Ys=new R,Lg=new R,Dg=new Ue,Ed=new R(1,0,0),Ad=new R(0,1,0),Cd=new R(0,0,1),Rd={type:"added"},Ng={type:"removed"},ns={type:"childadded",child:null},bc={type:"childremoved",child:null},Be=class i extends Cn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ig++}),this.uuid=Ds(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new R,e=new Kn,n=new Ue,s=new R(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new Ft}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new vs,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return es.setFromAxisAngle(t,e),this.quaternion.multiply(es),this}rotateOnWorldAxis(t,e){return es.setFromAxisAngle(t,e),this.quaternion.premultiply(es),this}rotateX(t){return this.rotateOnAxis(Ed,t)}rotateY(t){return this.rotateOnAxis(Ad,t)}rotateZ(t){return this.rotateOnAxis(Cd,t)}translateOnAxis(t,e){return Td.copy(t).applyQuaternion(this.quaternion),this.position.add(Td.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Ed,t)}translateY(t){return this.translateOnAxis(Ad,t)}translateZ(t){return this.translateOnAxis(Cd,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Hn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?_o.copy(t):_o.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ys.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Hn.lookAt(Ys,_o,this.up):Hn.lookAt(_o,Ys,this.up),this.quaternion.setFromRotationMatrix(Hn),s&&(Hn.extractRotation(s.matrixWorld),es.setFromRotationMatrix(Hn),this.quaternion.premultiply(es.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Nt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Rd),ns.child=t,this.dispatchEvent(ns),ns.child=null):Nt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Ng),bc.child=t,this.dispatchEvent(bc),bc.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Hn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Hn.multiply(t.parent.matrixWorld)),t.applyMatrix4(Hn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Rd),ns.child=t,this.dispatchEvent(ns),ns.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ys,t,Lg),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ys,Dg,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let f=l[c];r(t.shapes,f)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),f=o(t.shapes),u=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),u.length>0&&(n.skeletons=u),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Be.DEFAULT_UP=new R(0,1,0);Be.DEFAULT_MATRIX_AUTO_UPDATE=!0;Be.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Fn=class extends Be{constructor(){super(),this.isGroup=!0,this.type="Group"}},Og={type:"move"},bs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new R,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new R),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new R,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new R,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),_=this._getHandJoint(c,x);m!==null&&(_.matrix.fromArray(m.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=m.radius),_.visible=m!==null}let h=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],u=h.position.distanceTo(f.position),d=.02,g=.005;c.inputState.pinching&&u>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Og)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Fn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},kf={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ci={h:0,s:0,l:0},xo={h:0,s:0,l:0};function Sc(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var kt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=cn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Kt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Kt.workingColorSpace){return this.r=t,this.g=e,this.b=n,Kt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Kt.workingColorSpace){if(t=Sh(t,1),e=Ut(e,0,1),n=Ut(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Sc(o,r,t+1/3),this.g=Sc(o,r,t),this.b=Sc(o,r,t-1/3)}return Kt.colorSpaceToWorking(this,s),this}setStyle(t,e=cn){function n(r){r!==void 0&&parseFloat(r)<1&&Pt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Pt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Pt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=cn){let n=kf[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Pt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Yn(t.r),this.g=Yn(t.g),this.b=Yn(t.b),this}copyLinearToSRGB(t){return this.r=ps(t.r),this.g=ps(t.g),this.b=ps(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=cn){return Kt.workingToColorSpace(Xe.copy(this),t),Math.round(Ut(Xe.r*255,0,255))*65536+Math.round(Ut(Xe.g*255,0,255))*256+Math.round(Ut(Xe.b*255,0,255))}getHexString(t=cn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Kt.workingColorSpace){Kt.workingToColorSpace(Xe.copy(this),e);let n=Xe.r,s=Xe.g,r=Xe.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=h<=.5?f/(o+a):f/(2-o-a),o){case n:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-n)/f+2;break;case r:l=(n-s)/f+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Kt.workingColorSpace){return Kt.workingToColorSpace(Xe.copy(this),e),t.r=Xe.r,t.g=Xe.g,t.b=Xe.b,t}getStyle(t=cn){Kt.workingToColorSpace(Xe.copy(this),t);let e=Xe.r,n=Xe.g,s=Xe.b;return t!==cn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(ci),this.setHSL(ci.h+t,ci.s+e,ci.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(ci),t.getHSL(xo);let n=er(ci.h,xo.h,e),s=er(ci.s,xo.s,e),r=er(ci.l,xo.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Xe=new kt;kt.NAMES=kf;var cr=class extends Be{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Kn,this.environmentIntensity=1,this.environmentRotation=new Kn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},En=new R,Wn=new R,Mc=new R,Xn=new R,is=new R,ss=new R,Pd=new R,wc=new R,Tc=new R,Ec=new R,Ac=new _e,Cc=new _e,Rc=new _e,fi=class i{constructor(t=new R,e=new R,n=new R){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),En.subVectors(t,e),s.cross(En);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){En.subVectors(s,e),Wn.subVectors(n,e),Mc.subVectors(t,e);let o=En.dot(En),a=En.dot(Wn),l=En.dot(Mc),c=Wn.dot(Wn),h=Wn.dot(Mc),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let u=1/f,d=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-d-g,g,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Xn)===null?!1:Xn.x>=0&&Xn.y>=0&&Xn.x+Xn.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Xn)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Xn.x),l.addScaledVector(o,Xn.y),l.addScaledVector(a,Xn.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Ac.setScalar(0),Cc.setScalar(0),Rc.setScalar(0),Ac.fromBufferAttribute(t,e),Cc.fromBufferAttribute(t,n),Rc.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Ac,r.x),o.addScaledVector(Cc,r.y),o.addScaledVector(Rc,r.z),o}static isFrontFacing(t,e,n,s){return En.subVectors(n,e),Wn.subVectors(t,e),En.cross(Wn).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return En.subVectors(this.c,this.b),Wn.subVectors(this.a,this.b),En.cross(Wn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;is.subVectors(s,n),ss.subVectors(r,n),wc.subVectors(t,n);let l=is.dot(wc),c=ss.dot(wc);if(l<=0&&c<=0)return e.copy(n);Tc.subVectors(t,s);let h=is.dot(Tc),f=ss.dot(Tc);if(h>=0&&f<=h)return e.copy(s);let u=l*f-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(is,o);Ec.subVectors(t,r);let d=is.dot(Ec),g=ss.dot(Ec);if(g>=0&&d<=g)return e.copy(r);let x=d*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(ss,a);let m=h*g-d*f;if(m<=0&&f-h>=0&&d-g>=0)return Pd.subVectors(r,s),a=(f-h)/(f-h+(d-g)),e.copy(s).addScaledVector(Pd,a);let _=1/(m+x+u);return o=x*_,a=u*_,e.copy(n).addScaledVector(is,o).addScaledVector(ss,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},pi=class{constructor(t=new R(1/0,1/0,1/0),e=new R(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(An.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(An.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=An.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,An):An.fromBufferAttribute(r,o),An.applyMatrix4(t.matrixWorld),this.expandByPoint(An);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),yo.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),yo.copy(n.boundingBox)),yo.applyMatrix4(t.matrixWorld),this.union(yo)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,An),An.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Zs),vo.subVectors(this.max,Zs),rs.subVectors(t.a,Zs),os.subVectors(t.b,Zs),as.subVectors(t.c,Zs),hi.subVectors(os,rs),ui.subVectors(as,os),Di.subVectors(rs,as);let e=[0,-hi.z,hi.y,0,-ui.z,ui.y,0,-Di.z,Di.y,hi.z,0,-hi.x,ui.z,0,-ui.x,Di.z,0,-Di.x,-hi.y,hi.x,0,-ui.y,ui.x,0,-Di.y,Di.x,0];return!Pc(e,rs,os,as,vo)||(e=[1,0,0,0,1,0,0,0,1],!Pc(e,rs,os,as,vo))?!1:(bo.crossVectors(hi,ui),e=[bo.x,bo.y,bo.z],Pc(e,rs,os,as,vo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,An).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(An).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:($n[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),$n[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),$n[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),$n[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),$n[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),$n[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),$n[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),$n[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints($n),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},$n=[new R,new R,new R,new R,new R,new R,new R,new R],An=new R,yo=new pi,rs=new R,os=new R,as=new R,hi=new R,ui=new R,Di=new R,Zs=new R,vo=new R,bo=new R,Ni=new R;function Pc(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Ni.fromArray(i,r);let a=s.x*Math.abs(Ni.x)+s.y*Math.abs(Ni.y)+s.z*Math.abs(Ni.z),l=t.dot(Ni),c=e.dot(Ni),h=n.dot(Ni);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Me=new R,So=new Mt,Ug=0,un=class extends Cn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ug++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=If,this.updateRanges=[],this.gpuType=Pn,this.version=0,this._normalizationScale=t!==void 0?wh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)So.fromBufferAttribute(this,e),So.applyMatrix3(t),this.setXY(e,So.x,So.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Me.fromBufferAttribute(this,e),Me.applyMatrix3(t),this.setXYZ(e,Me.x,Me.y,Me.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Me.fromBufferAttribute(this,e),Me.applyMatrix4(t),this.setXYZ(e,Me.x,Me.y,Me.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Me.fromBufferAttribute(this,e),Me.applyNormalMatrix(t),this.setXYZ(e,Me.x,Me.y,Me.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Me.fromBufferAttribute(this,e),Me.transformDirection(t),this.setXYZ(e,Me.x,Me.y,Me.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Uf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ff(t,this.array)}};var hr=class extends un{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ur=class extends un{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var pe=class extends un{constructor(t,e,n){super(new Float32Array(t),e,n)}},Fg=new pi,Ks=new R,Ic=new R,Fi=class{constructor(t=new R,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Fg.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ks.subVectors(t,this.center);let e=Ks.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Ks,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Ic.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ks.copy(t.center).add(Ic)),this.expandByPoint(Ks.copy(t.center).sub(Ic))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},kg=0,vn=new Qt,Lc=new Be,ls=new R,ln=new pi,Js=new pi,Ne=new R,$e=class i extends Cn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:kg++}),this.uuid=Ds(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(cg(t)?ur:hr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Ft().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return vn.makeRotationFromQuaternion(t),this.applyMatrix4(vn),this}rotateX(t){return vn.makeRotationX(t),this.applyMatrix4(vn),this}rotateY(t){return vn.makeRotationY(t),this.applyMatrix4(vn),this}rotateZ(t){return vn.makeRotationZ(t),this.applyMatrix4(vn),this}translate(t,e,n){return vn.makeTranslation(t,e,n),this.applyMatrix4(vn),this}scale(t,e,n){return vn.makeScale(t,e,n),this.applyMatrix4(vn),this}lookAt(t){return Lc.lookAt(t),Lc.updateMatrix(),this.applyMatrix4(Lc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ls).negate(),this.translate(ls.x,ls.y,ls.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new pe(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Pt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new pi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new R(-1/0,-1/0,-1/0),new R(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ln.setFromBufferAttribute(r),this.morphTargetsRelative?(Ne.addVectors(this.boundingBox.min,ln.min),this.boundingBox.expandByPoint(Ne),Ne.addVectors(this.boundingBox.max,ln.max),this.boundingBox.expandByPoint(Ne)):(this.boundingBox.expandByPoint(ln.min),this.boundingBox.expandByPoint(ln.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new R,1/0);return}if(t){let n=this.boundingSphere.center;if(ln.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Js.setFromBufferAttribute(a),this.morphTargetsRelative?(Ne.addVectors(ln.min,Js.min),ln.expandByPoint(Ne),Ne.addVectors(ln.max,Js.max),ln.expandByPoint(Ne)):(ln.expandByPoint(Js.min),ln.expandByPoint(Js.max))}ln.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Ne.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Ne));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ne.fromBufferAttribute(a,c),l&&(ls.fromBufferAttribute(t,c),Ne.add(ls)),s=Math.max(s,n.distanceToSquared(Ne))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new un(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new R,l[U]=new R;let h=new R,f=new R,u=new R,d=new Mt,g=new Mt,x=new Mt,m=new R,_=new R;function v(U,L,O){c[U]=c[L]=c[O]=1,h.fromBufferAttribute(n,U),f.fromBufferAttribute(n,L),u.fromBufferAttribute(n,O),d.fromBufferAttribute(r,U),g.fromBufferAttribute(r,L),x.fromBufferAttribute(r,O),f.sub(h),u.sub(h),g.sub(d),x.sub(d);let B=1/(g.x*x.y-x.x*g.y);isFinite(B)&&(m.copy(f).multiplyScalar(x.y).addScaledVector(u,-g.y).multiplyScalar(B),_.copy(u).multiplyScalar(g.x).addScaledVector(f,-x.x).multiplyScalar(B),a[U].add(m),a[L].add(m),a[O].add(m),l[U].add(_),l[L].add(_),l[O].add(_))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let U=0,L=w.length;U<L;++U){let O=w[U],B=O.start,H=O.count;for(let D=B,Y=B+H;D<Y;D+=3)v(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let M=new R,P=new R,C=new R,y=new R;function T(U){C.fromBufferAttribute(s,U),y.copy(C);let L=a[U];M.copy(L),M.sub(C.multiplyScalar(C.dot(L))).normalize(),P.crossVectors(y,L);let B=P.dot(l[U])<0?-1:1;o.setXYZW(U,M.x,M.y,M.z,B)}for(let U=0,L=n.count;U<L;++U)c[U]&&T(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new un(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,d=n.count;u<d;u++)n.setXYZ(u,0,0,0);let s=new R,r=new R,o=new R,a=new R,l=new R,c=new R,h=new R,f=new R;if(t)for(let u=0,d=t.count;u<d;u+=3){let g=t.getX(u+0),x=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,d=e.count;u<d;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Ne.fromBufferAttribute(t,e),Ne.normalize(),t.setXYZ(e,Ne.x,Ne.y,Ne.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,f=a.normalized,u=new c.constructor(l.length*h),d=0,g=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?d=l[x]*a.data.stride+a.offset:d=l[x]*h;for(let _=0;_<h;_++)u[g++]=c[d++]}return new un(u,h,f)}if(this.index===null)return Pt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,f=c.length;h<f;h++){let u=c[h],d=t(u,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let f=0,u=c.length;f<u;f++){let d=c[f];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],f=r[c];for(let u=0,d=f.length;u<d;u++)h.push(f[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Dc=new R,Bg=new R,zg=new Ft,hn=class{constructor(t=new R(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Dc.subVectors(n,e).cross(Bg.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Dc),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||zg.getNormalMatrix(t),s=this.coplanarPoint(Dc).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Vg=0,Jn=class extends Cn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Vg++}),this.uuid=Ds(),this.name="",this.type="Material",this.blending=Ps,this.side=wi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=th,this.blendDst=eh,this.blendEquation=zi,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new kt(0,0,0),this.blendAlpha=0,this.depthFunc=ms,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Tf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=zo,this.stencilZFail=zo,this.stencilZPass=zo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Pt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Pt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new kt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new hn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Mt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Mt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var qn=new R,Nc=new R,Mo=new R,wo=new R,mi=class{constructor(t=new R,e=new R(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,qn)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=qn.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(qn.copy(this.origin).addScaledVector(this.direction,e),qn.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Nc.copy(t).add(e).multiplyScalar(.5),Mo.copy(e).sub(t).normalize(),wo.copy(this.origin).sub(Nc);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Mo),a=wo.dot(this.direction),l=-wo.dot(Mo),c=wo.lengthSq(),h=Math.abs(1-o*o),f,u,d,g;if(h>0)if(f=o*l-a,u=o*a-l,g=r*h,f>=0)if(u>=-g)if(u<=g){let x=1/h;f*=x,u*=x,d=f*(f+o*u+2*a)+u*(o*f+u+2*l)+c}else u=r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;else u=-r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;else u<=-g?(f=Math.max(0,-(-o*r+a)),u=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+u*(u+2*l)+c):u<=g?(f=0,u=Math.min(Math.max(-r,-l),r),d=u*(u+2*l)+c):(f=Math.max(0,-(o*r+a)),u=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+u*(u+2*l)+c);else u=o>0?-r:r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Nc).addScaledVector(Mo,u),d}intersectSphere(t,e){if(t.radius<0)return null;qn.subVectors(t.center,this.origin);let n=qn.dot(this.direction),s=qn.dot(qn)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(t.min.z-u.z)*f,l=(t.max.z-u.z)*f):(a=(t.max.z-u.z)*f,l=(t.min.z-u.z)*f),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,qn)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,f=t.x-o.x,u=t.y-o.y,d=t.z-o.z,g=e.x-o.x,x=e.y-o.y,m=e.z-o.z,_=n.x-o.x,v=n.y-o.y,w=n.z-o.z,M=Math.abs(l),P=Math.abs(c),C=Math.abs(h),y,T,U,L,O,B,H,D,Y,J,X,nt;if(M>=P&&M>=C?(U=l,B=f,Y=g,nt=_,l>=0?(y=c,T=h,L=u,O=d,H=x,D=m,J=v,X=w):(y=h,T=c,L=d,O=u,H=m,D=x,J=w,X=v)):P>=C?(U=c,B=u,Y=x,nt=v,c>=0?(y=h,T=l,L=d,O=f,H=m,D=g,J=w,X=_):(y=l,T=h,L=f,O=d,H=g,D=m,J=_,X=w)):(U=h,B=d,Y=m,nt=w,h>=0?(y=l,T=c,L=f,O=u,H=g,D=x,J=_,X=v):(y=c,T=l,L=u,O=f,H=x,D=g,J=v,X=_)),U===0)return null;let q=y/U,k=T/U,Z=1/U,dt=L-q*B,at=O-k*B,W=H-q*Y,it=D-k*Y,ct=J-q*nt,St=X-k*nt,lt=ct*it-St*W,Lt=dt*St-at*ct,xe=W*at-it*dt;if(s){if(lt<0||Lt<0||xe<0)return null}else if((lt<0||Lt<0||xe<0)&&(lt>0||Lt>0||xe>0))return null;let Dt=lt+Lt+xe;if(Dt===0)return null;let se=Z*(lt*B+Lt*Y+xe*nt);return(Dt>0?se<0:se>0)?null:this.at(se/Dt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ta=class extends Jn{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new kt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Kn,this.combine=Ca,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Id=new Qt,Oi=new mi,To=new Fi,Ld=new R,Eo=new R,Ao=new R,Co=new R,Oc=new R,Ro=new R,Dd=new R,Po=new R,ze=class extends Be{constructor(t=new $e,e=new ta){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ro.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],f=r[l];h!==0&&(Oc.fromBufferAttribute(f,t),o?Ro.addScaledVector(Oc,h):Ro.addScaledVector(Oc.sub(e),h))}e.add(Ro)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),To.copy(n.boundingSphere),To.applyMatrix4(r),Oi.copy(t.ray).recast(t.near),!(To.containsPoint(Oi.origin)===!1&&(Oi.intersectSphere(To,Ld)===null||Oi.origin.distanceToSquared(Ld)>(t.far-t.near)**2))&&(Id.copy(r).invert(),Oi.copy(t.ray).applyMatrix4(Id),!(n.boundingBox!==null&&Oi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Oi)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,u=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let m=u[g],_=o[m.materialIndex],v=Math.max(m.start,d.start),w=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let M=v,P=w;M<P;M+=3){let C=a.getX(M),y=a.getX(M+1),T=a.getX(M+2);s=Io(this,_,t,n,c,h,f,C,y,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),x=Math.min(a.count,d.start+d.count);for(let m=g,_=x;m<_;m+=3){let v=a.getX(m),w=a.getX(m+1),M=a.getX(m+2);s=Io(this,o,t,n,c,h,f,v,w,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let m=u[g],_=o[m.materialIndex],v=Math.max(m.start,d.start),w=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let M=v,P=w;M<P;M+=3){let C=M,y=M+1,T=M+2;s=Io(this,_,t,n,c,h,f,C,y,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),x=Math.min(l.count,d.start+d.count);for(let m=g,_=x;m<_;m+=3){let v=m,w=m+1,M=m+2;s=Io(this,o,t,n,c,h,f,v,w,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Gg(i,t,e,n,s,r,o,a){let l;if(t.side===Je?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===wi,a),l===null)return null;Po.copy(a),Po.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Po);return c<e.near||c>e.far?null:{distance:c,point:Po.clone(),object:i}}function Io(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Eo),i.getVertexPosition(l,Ao),i.getVertexPosition(c,Co);let h=Gg(i,t,e,n,Eo,Ao,Co,Dd);if(h){let f=new R;fi.getBarycoord(Dd,Eo,Ao,Co,f),s&&(h.uv=fi.getInterpolatedAttribute(s,a,l,c,f,new Mt)),r&&(h.uv1=fi.getInterpolatedAttribute(r,a,l,c,f,new Mt)),o&&(h.normal=fi.getInterpolatedAttribute(o,a,l,c,f,new R),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new R,materialIndex:0};fi.getNormal(Eo,Ao,Co,u.normal),h.face=u,h.barycoord=f}return h}var ea=class extends tn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Oe,h=Oe,f,u){super(null,o,a,l,c,h,s,r,f,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ui=new Fi,Hg=new Mt(.5,.5),Lo=new R,gi=class{constructor(t=new hn,e=new hn,n=new hn,s=new hn,r=new hn,o=new hn){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=bn,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],f=r[5],u=r[6],d=r[7],g=r[8],x=r[9],m=r[10],_=r[11],v=r[12],w=r[13],M=r[14],P=r[15];if(s[0].setComponents(c-o,d-h,_-g,P-v).normalize(),s[1].setComponents(c+o,d+h,_+g,P+v).normalize(),s[2].setComponents(c+a,d+f,_+x,P+w).normalize(),s[3].setComponents(c-a,d-f,_-x,P-w).normalize(),n)s[4].setComponents(l,u,m,M).normalize(),s[5].setComponents(c-l,d-u,_-m,P-M).normalize();else if(s[4].setComponents(c-l,d-u,_-m,P-M).normalize(),e===bn)s[5].setComponents(c+l,d+u,_+m,P+M).normalize();else if(e===gs)s[5].setComponents(l,u,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ui.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ui.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ui)}intersectsSprite(t){Ui.center.set(0,0,0);let e=Hg.distanceTo(t.center);return Ui.radius=.7071067811865476+e,Ui.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ui)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Lo.x=s.normal.x>0?t.max.x:t.min.x,Lo.y=s.normal.y>0?t.max.y:t.min.y,Lo.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Lo)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Nd=new Qt,na=class i{constructor(){this.coordinateSystem=bn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Nd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new gi),n[s].setFromProjectionMatrix(Nd,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new gi),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var _i=class extends Jn{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new kt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},ia=new R,sa=new R,Od=new Qt,js=new mi,Do=new Fi,Uc=new R,Ud=new R,ra=class extends Be{constructor(t=new $e,e=new _i){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)ia.fromBufferAttribute(e,s-1),sa.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=ia.distanceTo(sa);t.setAttribute("lineDistance",new pe(n,1))}else Pt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Do.copy(n.boundingSphere),Do.applyMatrix4(s),Do.radius+=r,t.ray.intersectsSphere(Do)===!1)return;Od.copy(s).invert(),js.copy(t.ray).applyMatrix4(Od);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=d,m=g-1;x<m;x+=c){let _=h.getX(x),v=h.getX(x+1),w=No(this,t,js,l,_,v,x);w&&e.push(w)}if(this.isLineLoop){let x=h.getX(g-1),m=h.getX(d),_=No(this,t,js,l,x,m,g-1);_&&e.push(_)}}else{let d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let x=d,m=g-1;x<m;x+=c){let _=No(this,t,js,l,x,x+1,x);_&&e.push(_)}if(this.isLineLoop){let x=No(this,t,js,l,g-1,d,g-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function No(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(ia.fromBufferAttribute(a,s),sa.fromBufferAttribute(a,r),e.distanceSqToSegment(ia,sa,Uc,Ud)>n)return;Uc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Uc);if(!(c<t.near||c>t.far))return{distance:c,point:Ud.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Fd=new R,kd=new R,Ss=class extends ra{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Fd.fromBufferAttribute(e,s),kd.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Fd.distanceTo(kd);t.setAttribute("lineDistance",new pe(n,1))}else Pt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var dr=class extends tn{constructor(t=[],e=Vi,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var jn=class extends tn{constructor(t,e,n=Rn,s,r,o,a=Oe,l=Oe,c,h=Zn,f=1){if(h!==Zn&&h!==ti)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:f};super(u,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ys(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},fr=class extends jn{constructor(t,e=Rn,n=Vi,s,r,o=Oe,a=Oe,l,c=Zn){let h={width:t,height:t,depth:1},f=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},pr=class extends tn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ms=class i extends $e{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],f=[],u=0,d=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new pe(c,3)),this.setAttribute("normal",new pe(h,3)),this.setAttribute("uv",new pe(f,2));function g(x,m,_,v,w,M,P,C,y,T,U){let L=M/y,O=P/T,B=M/2,H=P/2,D=C/2,Y=y+1,J=T+1,X=0,nt=0,q=new R;for(let k=0;k<J;k++){let Z=k*O-H;for(let dt=0;dt<Y;dt++){let at=dt*L-B;q[x]=at*v,q[m]=Z*w,q[_]=D,c.push(q.x,q.y,q.z),q[x]=0,q[m]=0,q[_]=C>0?1:-1,h.push(q.x,q.y,q.z),f.push(dt/y),f.push(1-k/T),X+=1}}for(let k=0;k<T;k++)for(let Z=0;Z<y;Z++){let dt=u+Z+Y*k,at=u+Z+Y*(k+1),W=u+(Z+1)+Y*(k+1),it=u+(Z+1)+Y*k;l.push(dt,at,it),l.push(at,W,it),nt+=6}a.addGroup(d,nt,U),d+=nt,u+=X}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ws=class i extends $e{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],f=[],u=[],d=[],g=0,x=[],m=n/2,_=0;v(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new pe(f,3)),this.setAttribute("normal",new pe(u,3)),this.setAttribute("uv",new pe(d,2));function v(){let M=new R,P=new R,C=0,y=(e-t)/n;for(let T=0;T<=r;T++){let U=[],L=T/r,O=L*(e-t)+t;for(let B=0;B<=s;B++){let H=B/s,D=H*l+a,Y=Math.sin(D),J=Math.cos(D);P.x=O*Y,P.y=-L*n+m,P.z=O*J,f.push(P.x,P.y,P.z),M.set(Y,y,J).normalize(),u.push(M.x,M.y,M.z),d.push(H,1-L),U.push(g++)}x.push(U)}for(let T=0;T<s;T++)for(let U=0;U<r;U++){let L=x[U][T],O=x[U+1][T],B=x[U+1][T+1],H=x[U][T+1];(t>0||U!==0)&&(h.push(L,O,H),C+=3),(e>0||U!==r-1)&&(h.push(O,B,H),C+=3)}c.addGroup(_,C,0),_+=C}function w(M){let P=g,C=new Mt,y=new R,T=0,U=M===!0?t:e,L=M===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,m*L,0),u.push(0,L,0),d.push(.5,.5),g++;let O=g;for(let B=0;B<=s;B++){let D=B/s*l+a,Y=Math.cos(D),J=Math.sin(D);y.x=U*J,y.y=m*L,y.z=U*Y,f.push(y.x,y.y,y.z),u.push(0,L,0),C.x=Y*.5+.5,C.y=J*.5*L+.5,d.push(C.x,C.y),g++}for(let B=0;B<s;B++){let H=P+B,D=O+B;M===!0?h.push(D,D+1,H):h.push(D+1,D,H),T+=3}c.addGroup(_,T,M===!0?1:2),_+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Sn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Pt("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],u=n[s+1]-h,d=(o-h)/u;return(s+d)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new Mt:new R);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new R,s=[],r=[],o=[],a=new R,l=new Qt;for(let d=0;d<=t;d++){let g=d/t;s[d]=this.getTangentAt(g,new R)}r[0]=new R,o[0]=new R;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),f=Math.abs(s[0].y),u=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),f<=c&&(c=f,n.set(0,1,0)),u<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let d=1;d<=t;d++){if(r[d]=r[d-1].clone(),o[d]=o[d-1].clone(),a.crossVectors(s[d-1],s[d]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(Ut(s[d-1].dot(s[d]),-1,1));r[d].applyMatrix4(l.makeRotationAxis(a,g))}o[d].crossVectors(s[d],r[d])}if(e===!0){let d=Math.acos(Ut(r[0].dot(r[t]),-1,1));d/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(d=-d);for(let g=1;g<=t;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],d*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},mr=class extends Sn{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new Mt){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),f=Math.sin(this.aRotation),u=l-this.aX,d=c-this.aY;l=u*h-d*f+this.aX,c=u*f+d*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},oa=class extends mr{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Eh(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,f){let u=(o-r)/c-(a-r)/(c+h)+(a-o)/h,d=(a-o)/h-(l-o)/(h+f)+(l-a)/f;u*=h,d*=h,s(o,a,u,d)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var Bd=new R,zd=new R,Fc=new Eh,kc=new Eh,Bc=new Eh,Ts=class extends Sn{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new R){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(zd.subVectors(s[0],s[1]).add(s[0]),c=zd);let f=s[a%r],u=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(Bd.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Bd),this.curveType==="centripetal"||this.curveType==="chordal"){let d=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(f),d),x=Math.pow(f.distanceToSquared(u),d),m=Math.pow(u.distanceToSquared(h),d);x<1e-4&&(x=1),g<1e-4&&(g=x),m<1e-4&&(m=x),Fc.initNonuniformCatmullRom(c.x,f.x,u.x,h.x,g,x,m),kc.initNonuniformCatmullRom(c.y,f.y,u.y,h.y,g,x,m),Bc.initNonuniformCatmullRom(c.z,f.z,u.z,h.z,g,x,m)}else this.curveType==="catmullrom"&&(Fc.initCatmullRom(c.x,f.x,u.x,h.x,this.tension),kc.initCatmullRom(c.y,f.y,u.y,h.y,this.tension),Bc.initCatmullRom(c.z,f.z,u.z,h.z,this.tension));return n.set(Fc.calc(l),kc.calc(l),Bc.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new R().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Vd(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function Wg(i,t){let e=1-i;return e*e*t}function Xg(i,t){return 2*(1-i)*i*t}function $g(i,t){return i*i*t}function nr(i,t,e,n){return Wg(i,t)+Xg(i,e)+$g(i,n)}function qg(i,t){let e=1-i;return e*e*e*t}function Yg(i,t){let e=1-i;return 3*e*e*i*t}function Zg(i,t){return 3*(1-i)*i*i*t}function Kg(i,t){return i*i*i*t}function ir(i,t,e,n,s){return qg(i,t)+Yg(i,e)+Zg(i,n)+Kg(i,s)}var aa=class extends Sn{constructor(t=new Mt,e=new Mt,n=new Mt,s=new Mt){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new Mt){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ir(t,s.x,r.x,o.x,a.x),ir(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},la=class extends Sn{constructor(t=new R,e=new R,n=new R,s=new R){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new R){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ir(t,s.x,r.x,o.x,a.x),ir(t,s.y,r.y,o.y,a.y),ir(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},ca=class extends Sn{constructor(t=new Mt,e=new Mt){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Mt){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Mt){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ha=class extends Sn{constructor(t=new R,e=new R){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new R){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new R){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ua=class extends Sn{constructor(t=new Mt,e=new Mt,n=new Mt){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new Mt){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(nr(t,s.x,r.x,o.x),nr(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},gr=class extends Sn{constructor(t=new R,e=new R,n=new R){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new R){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(nr(t,s.x,r.x,o.x),nr(t,s.y,r.y,o.y),nr(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},da=class extends Sn{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Mt){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],f=s[o>s.length-3?s.length-1:o+2];return n.set(Vd(a,l.x,c.x,h.x,f.x),Vd(a,l.y,c.y,h.y,f.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new Mt().fromArray(s))}return this}},Jg=Object.freeze({__proto__:null,ArcCurve:oa,CatmullRomCurve3:Ts,CubicBezierCurve:aa,CubicBezierCurve3:la,EllipseCurve:mr,LineCurve:ca,LineCurve3:ha,QuadraticBezierCurve:ua,QuadraticBezierCurve3:gr,SplineCurve:da});var _r=class i extends $e{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,f=t/a,u=e/l,d=[],g=[],x=[],m=[];for(let _=0;_<h;_++){let v=_*u-o;for(let w=0;w<c;w++){let M=w*f-r;g.push(M,-v,0),x.push(0,0,1),m.push(w/a),m.push(1-_/l)}}for(let _=0;_<l;_++)for(let v=0;v<a;v++){let w=v+c*_,M=v+c*(_+1),P=v+1+c*(_+1),C=v+1+c*_;d.push(w,M,C),d.push(M,P,C)}this.setIndex(d),this.setAttribute("position",new pe(g,3)),this.setAttribute("normal",new pe(x,3)),this.setAttribute("uv",new pe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var xr=class i extends $e{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],f=new R,u=new R,d=[],g=[],x=[],m=[];for(let _=0;_<=n;_++){let v=[],w=_/n,M=o+w*a,P=t*Math.cos(M),C=Math.sqrt(t*t-P*P),y=0;_===0&&o===0?y=.5/e:_===n&&l===Math.PI&&(y=-.5/e);for(let T=0;T<=e;T++){let U=T/e,L=s+U*r;f.x=-C*Math.cos(L),f.y=P,f.z=C*Math.sin(L),g.push(f.x,f.y,f.z),u.copy(f).normalize(),x.push(u.x,u.y,u.z),m.push(U+y,1-w),v.push(c++)}h.push(v)}for(let _=0;_<n;_++)for(let v=0;v<e;v++){let w=h[_][v+1],M=h[_][v],P=h[_+1][v],C=h[_+1][v+1];(_!==0||o>0)&&d.push(w,M,C),(_!==n-1||l<Math.PI)&&d.push(M,P,C)}this.setIndex(d),this.setAttribute("position",new pe(g,3)),this.setAttribute("normal",new pe(x,3)),this.setAttribute("uv",new pe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var yr=class i extends $e{constructor(t=new gr(new R(-1,-1,0),new R(-1,1,0),new R(1,1,0)),e=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:t,tubularSegments:e,radius:n,radialSegments:s,closed:r};let o=t.computeFrenetFrames(e,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new R,l=new R,c=new Mt,h=new R,f=[],u=[],d=[],g=[];x(),this.setIndex(g),this.setAttribute("position",new pe(f,3)),this.setAttribute("normal",new pe(u,3)),this.setAttribute("uv",new pe(d,2));function x(){for(let w=0;w<e;w++)m(w);m(r===!1?e:0),v(),_()}function m(w){h=t.getPointAt(w/e,h);let M=o.normals[w],P=o.binormals[w];for(let C=0;C<=s;C++){let y=C/s*Math.PI*2,T=Math.sin(y),U=-Math.cos(y);l.x=U*M.x+T*P.x,l.y=U*M.y+T*P.y,l.z=U*M.z+T*P.z,l.normalize(),u.push(l.x,l.y,l.z),a.x=h.x+n*l.x,a.y=h.y+n*l.y,a.z=h.z+n*l.z,f.push(a.x,a.y,a.z)}}function _(){for(let w=1;w<=e;w++)for(let M=1;M<=s;M++){let P=(s+1)*(w-1)+(M-1),C=(s+1)*w+(M-1),y=(s+1)*w+M,T=(s+1)*(w-1)+M;g.push(P,C,T),g.push(C,y,T)}}function v(){for(let w=0;w<=e;w++)for(let M=0;M<=s;M++)c.x=w/e,c.y=M/s,d.push(c.x,c.y)}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON();return t.path=this.parameters.path.toJSON(),t}static fromJSON(t){return new i(new Jg[t.path.type]().fromJSON(t.path),t.tubularSegments,t.radius,t.radialSegments,t.closed)}};function Hi(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Gd(s))s.isRenderTargetTexture?(Pt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Gd(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function qe(i){let t={};for(let e=0;e<i.length;e++){let n=Hi(i[e]);for(let s in n)t[s]=n[s]}return t}function Gd(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function jg(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Ah(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Kt.workingColorSpace}var Bf={clone:Hi,merge:qe},Qg=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,t_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,kn=class extends Jn{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Qg,this.fragmentShader=t_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Hi(t.uniforms),this.uniformsGroups=jg(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new kt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Mt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new R().fromArray(s.value);break;case"v4":this.uniforms[n].value=new _e().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Ft().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},fa=class extends kn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var xi=class extends Jn{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new kt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new kt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=pl,this.normalScale=new Mt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Kn,this.combine=Ca,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},pa=class extends Jn{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Mf,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ma=class extends Jn{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function cs(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Oo(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var yi=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];t:{e:{let o;n:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break e}o=e.length;break n}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break e}o=n,n=0;break n}break t}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ga=class extends yi{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hc,endingEnd:Hc}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Wc:r=t,a=2*e-n;break;case Xc:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Wc:o=t,l=2*n-e;break;case Xc:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,f=this._offsetNext,u=this._weightPrev,d=this._weightNext,g=(n-e)/(s-e),x=g*g,m=x*g,_=-u*m+2*u*x-u*g,v=(1+u)*m+(-1.5-2*u)*x+(-.5+u)*g+1,w=(-1-d)*m+(1.5+d)*x+.5*g,M=d*m-d*x;for(let P=0;P!==a;++P)r[P]=_*o[h+P]+v*o[c+P]+w*o[l+P]+M*o[f+P];return r}},_a=class extends yi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),f=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*f+o[l+u]*h;return r}},xa=class extends yi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},ya=class extends yi{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(n-e)/(s-e),x=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*g;return r}let u=a*2,d=t-1;for(let g=0;g!==a;++g){let x=o[c+g],m=o[l+g],_=d*u+g*2,v=f[_],w=f[_+1],M=t*u+g*2,P=h[M],C=h[M+1],y=n_(n,e,v,P,s);r[g]=zf(y,x,w,C,m)}return r}};function zf(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function e_(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function n_(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=zf(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=e_(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var fn=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=cs(e,this.TimeBufferType),this.values=cs(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:cs(t.times,Array),values:cs(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Oo(t.settings)&&(n.settings={inTangents:cs(t.settings.inTangents,Array),outTangents:cs(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new xa(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new _a(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new ga(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new ya(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case sr:e=this.InterpolantFactoryMethodDiscrete;break;case Ko:e=this.InterpolantFactoryMethodLinear;break;case Bo:e=this.InterpolantFactoryMethodSmooth;break;case Gc:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Pt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return sr;case this.InterpolantFactoryMethodLinear:return Ko;case this.InterpolantFactoryMethodSmooth:return Bo;case this.InterpolantFactoryMethodBezier:return Gc}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Oo(this.settings)&&(Hd(this.settings.inTangents,t),Hd(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Oo(this.settings)&&(Wd(this.settings.inTangents,t),Wd(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Nt("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Nt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Nt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Nt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&hg(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Nt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Bo,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let f=a*n,u=f-n,d=f+n;for(let g=0;g!==n;++g){let x=e[f+g];if(x!==e[u+g]||x!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let f=a*n,u=o*n;for(let d=0;d!==n;++d)e[u+d]=e[f+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Oo(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Hd(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Wd(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}fn.prototype.ValueTypeName="";fn.prototype.TimeBufferType=Float32Array;fn.prototype.ValueBufferType=Float32Array;fn.prototype.DefaultInterpolation=Ko;var vi=class extends fn{constructor(t,e,n){super(t,e,n)}};vi.prototype.ValueTypeName="bool";vi.prototype.ValueBufferType=Array;vi.prototype.DefaultInterpolation=sr;vi.prototype.InterpolantFactoryMethodLinear=void 0;vi.prototype.InterpolantFactoryMethodSmooth=void 0;var va=class extends fn{constructor(t,e,n,s){super(t,e,n,s)}};va.prototype.ValueTypeName="color";var ba=class extends fn{constructor(t,e,n,s){super(t,e,n,s)}};ba.prototype.ValueTypeName="number";var Sa=class extends yi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Ue.slerpFlat(r,0,o,c-a,o,c,l);return r}},vr=class extends fn{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Sa(this.times,this.values,this.getValueSize(),t)}};vr.prototype.ValueTypeName="quaternion";vr.prototype.InterpolantFactoryMethodSmooth=void 0;var bi=class extends fn{constructor(t,e,n){super(t,e,n)}};bi.prototype.ValueTypeName="string";bi.prototype.ValueBufferType=Array;bi.prototype.DefaultInterpolation=sr;bi.prototype.InterpolantFactoryMethodLinear=void 0;bi.prototype.InterpolantFactoryMethodSmooth=void 0;var Ma=class extends fn{constructor(t,e,n,s){super(t,e,n,s)}};Ma.prototype.ValueTypeName="vector";var wa=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,f){return c.push(h,f),this},this.removeHandler=function(h){let f=c.indexOf(h);return f!==-1&&c.splice(f,2),this},this.getHandler=function(h){for(let f=0,u=c.length;f<u;f+=2){let d=c[f],g=c[f+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Vf=new wa,Ta=class{constructor(t){this.manager=t!==void 0?t:Vf,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Ta.DEFAULT_MATERIAL_NAME="__DEFAULT";var Es=class extends Be{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new kt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},br=class extends Es{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Be.DEFAULT_UP),this.updateMatrix(),this.groundColor=new kt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},zc=new Qt,Xd=new R,$d=new R,Ea=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Mt(512,512),this.mapType=en,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new gi,this._frameExtents=new Mt(1,1),this._viewportCount=1,this._viewports=[new _e(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Xd.setFromMatrixPosition(t.matrixWorld),e.position.copy(Xd),$d.setFromMatrixPosition(t.target.matrixWorld),e.lookAt($d),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){zc.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(zc,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===gs||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(zc)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Uo=new R,Fo=new Ue,On=new R,Sr=class extends Be{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=bn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Uo,Fo,On),On.x===1&&On.y===1&&On.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uo,Fo,On.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Uo,Fo,On),On.x===1&&On.y===1&&On.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uo,Fo,On.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},di=new R,qd=new Mt,Yd=new Mt,Ze=class extends Sr{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=xs*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(tr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return xs*2*Math.atan(Math.tan(tr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){di.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(di.x,di.y).multiplyScalar(-t/di.z),di.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(di.x,di.y).multiplyScalar(-t/di.z)}getViewSize(t,e){return this.getViewBounds(t,qd,Yd),e.subVectors(Yd,qd)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(tr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ki=class extends Sr{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},$c=class extends Ea{constructor(){super(new ki(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Mr=class extends Es{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Be.DEFAULT_UP),this.updateMatrix(),this.target=new Be,this.shadow=new $c}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},wr=class extends Es{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var hs=-90,us=1,As=class extends Be{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ze(hs,us,t,e);s.layers=this.layers,this.add(s);let r=new Ze(hs,us,t,e);r.layers=this.layers,this.add(r);let o=new Ze(hs,us,t,e);o.layers=this.layers,this.add(o);let a=new Ze(hs,us,t,e);a.layers=this.layers,this.add(a);let l=new Ze(hs,us,t,e);l.layers=this.layers,this.add(l);let c=new Ze(hs,us,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===bn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===gs)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,f=t.getRenderTarget(),u=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(f,u,d),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Aa=class extends Ze{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Ch="\\[\\]\\.:\\/",i_=new RegExp("["+Ch+"]","g"),Rh="[^"+Ch+"]",s_="[^"+Ch.replace("\\.","")+"]",r_=/((?:WC+[\/:])*)/.source.replace("WC",Rh),o_=/(WCOD+)?/.source.replace("WCOD",s_),a_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Rh),l_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Rh),c_=new RegExp("^"+r_+o_+a_+l_+"$"),h_=["material","materials","bones","map"],qc=class{constructor(t,e,n){let s=n||fe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},fe=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(i_,"")}static parseTrackName(t){let e=c_.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);h_.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Pt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){Nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){Nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};fe.Composite=qc;fe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};fe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};fe.prototype.GetterByBindingType=[fe.prototype._getValue_direct,fe.prototype._getValue_array,fe.prototype._getValue_arrayElement,fe.prototype._getValue_toArray];fe.prototype.SetterByBindingTypeAndVersioning=[[fe.prototype._setValue_direct,fe.prototype._setValue_direct_setNeedsUpdate,fe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[fe.prototype._setValue_array,fe.prototype._setValue_array_setNeedsUpdate,fe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[fe.prototype._setValue_arrayElement,fe.prototype._setValue_arrayElement_setNeedsUpdate,fe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[fe.prototype._setValue_fromArray,fe.prototype._setValue_fromArray_setNeedsUpdate,fe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var AM=new Float32Array(1);var Zd=new Qt,Tr=class{constructor(t,e,n=0,s=1/0){this.ray=new mi(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new vs,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Nt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Zd.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Zd),this}intersectObject(t,e=!0,n=[]){return Yc(t,this,n,e),n.sort(Kd),n}intersectObjects(t,e=!0,n=[]){for(let s=0,r=t.length;s<r;s++)Yc(t[s],this,n,e);return n.sort(Kd),n}};function Kd(i,t){return i.distance-t.distance}function Yc(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Yc(r[o],t,e,!0)}}var Cs=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Ut(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(Ut(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Zc=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Jd=new R,ko=new R,ds=new R,fs=new R,Vc=new R,u_=new R,d_=new R,Er=class{constructor(t=new R,e=new R){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){Jd.subVectors(t,this.start),ko.subVectors(this.end,this.start);let n=ko.dot(ko);if(n===0)return 0;let r=ko.dot(Jd)/n;return e&&(r=Ut(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=u_,n=d_){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,h=t.end;ds.subVectors(c,a),fs.subVectors(h,l),Vc.subVectors(a,l);let f=ds.dot(ds),u=fs.dot(fs),d=fs.dot(Vc);if(f<=s&&u<=s)return e.copy(a),n.copy(l),e.distanceToSquared(n);if(f<=s)r=0,o=d/u,o=Ut(o,0,1);else{let g=ds.dot(Vc);if(u<=s)o=0,r=Ut(-g/f,0,1);else{let x=ds.dot(fs),m=f*u-x*x;m!==0?r=Ut((x*d-g*u)/m,0,1):r=0,o=(x*r+d)/u,o<0?(o=0,r=Ut(-g/f,0,1)):o>1&&(o=1,r=Ut((x-g)/f,0,1))}}return e.copy(a).addScaledVector(ds,r),n.copy(l).addScaledVector(fs,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Ar=class extends Ss{constructor(t=10,e=10,n=4473924,s=8947848){n=new kt(n),s=new kt(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let u=0,d=0,g=-a;u<=e;u++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let x=u===r?n:s;x.toArray(c,d),d+=3,x.toArray(c,d),d+=3,x.toArray(c,d),d+=3,x.toArray(c,d),d+=3}let h=new $e;h.setAttribute("position",new pe(l,3)),h.setAttribute("color",new pe(c,3));let f=new _i({vertexColors:!0,toneMapped:!1});super(h,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Cr=class extends Cn{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Ph(i,t,e,n){let s=f_(n);switch(e){case ph:return i*t;case gh:return i*t/s.components*s.byteLength;case Oa:return i*t/s.components*s.byteLength;case Ti:return i*t*2/s.components*s.byteLength;case Ua:return i*t*2/s.components*s.byteLength;case mh:return i*t*3/s.components*s.byteLength;case Ln:return i*t*4/s.components*s.byteLength;case Fa:return i*t*4/s.components*s.byteLength;case Ir:case Lr:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Dr:case Nr:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Ba:case Va:return Math.max(i,16)*Math.max(t,8)/4;case ka:case za:return Math.max(i,8)*Math.max(t,8)/2;case Ga:case Ha:case Xa:case $a:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Wa:case Or:case qa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Ya:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Za:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Ka:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Ja:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ja:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Qa:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case tl:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case el:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case nl:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case il:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case sl:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case rl:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case ol:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case al:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case ll:case cl:case hl:return Math.ceil(i/4)*Math.ceil(t/4)*16;case ul:case dl:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ur:case fl:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function f_(i){switch(i){case en:case hh:return{byteLength:1,components:1};case Ls:case uh:case In:return{byteLength:2,components:1};case Da:case Na:return{byteLength:2,components:4};case Rn:case La:case Pn:return{byteLength:4,components:1};case dh:case fh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Pt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function cp(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function m_(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,f=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function n(a,l,c){let h=l.array,f=l.updateRanges;if(i.bindBuffer(c,a),f.length===0)i.bufferSubData(c,0,h);else{f.sort((d,g)=>d.start-g.start);let u=0;for(let d=1;d<f.length;d++){let g=f[u],x=f[d];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++u,f[u]=x)}f.length=u+1;for(let d=0,g=f.length;d<g;d++){let x=f[d];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var g_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,__=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,x_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,y_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,v_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,b_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,S_=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,M_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,w_=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,T_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,E_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,A_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,C_=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,R_=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,P_=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,I_=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,L_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,D_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,N_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,O_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,U_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,F_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,k_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,B_=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,z_=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,V_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,G_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,H_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,W_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,X_="gl_FragColor = linearToOutputTexel( gl_FragColor );",$_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,q_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Y_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Z_=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,K_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,J_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,j_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Q_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,t0=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,e0=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,n0=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,i0=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,s0=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,r0=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,o0=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,a0=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,l0=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,c0=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,h0=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,u0=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,d0=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,f0=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,p0=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,m0=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,g0=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,_0=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,x0=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,y0=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,v0=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,b0=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,S0=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,M0=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,w0=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,T0=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,E0=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,A0=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,C0=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,R0=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,P0=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,I0=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,L0=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,D0=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,N0=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,O0=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,U0=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,F0=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,k0=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,B0=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,z0=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,V0=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,G0=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,H0=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,W0=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,X0=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$0=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,q0=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Y0=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Z0=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,K0=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,J0=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,j0=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Q0=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,tx=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ex=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,nx=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,ix=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sx=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,rx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ox=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ax=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lx=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,cx=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,hx=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,ux=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,dx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,fx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,px=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,mx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gx=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_x=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xx=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Sx=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Mx=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,wx=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Tx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ex=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ax=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Cx=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Rx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Px=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ix=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Lx=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Dx=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Nx=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ox=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Ux=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Fx=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,kx=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Bx=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,zx=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vx=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Gx=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hx=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Wx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Xx=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$x=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,qx=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Yx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Wt={alphahash_fragment:g_,alphahash_pars_fragment:__,alphamap_fragment:x_,alphamap_pars_fragment:y_,alphatest_fragment:v_,alphatest_pars_fragment:b_,aomap_fragment:S_,aomap_pars_fragment:M_,batching_pars_vertex:w_,batching_vertex:T_,begin_vertex:E_,beginnormal_vertex:A_,bsdfs:C_,iridescence_fragment:R_,bumpmap_pars_fragment:P_,clipping_planes_fragment:I_,clipping_planes_pars_fragment:L_,clipping_planes_pars_vertex:D_,clipping_planes_vertex:N_,color_fragment:O_,color_pars_fragment:U_,color_pars_vertex:F_,color_vertex:k_,common:B_,defaultnormal_vertex:z_,displacementmap_pars_vertex:V_,displacementmap_vertex:G_,emissivemap_fragment:H_,emissivemap_pars_fragment:W_,colorspace_fragment:X_,colorspace_pars_fragment:$_,envmap_fragment:q_,envmap_common_pars_fragment:Y_,envmap_pars_fragment:Z_,envmap_pars_vertex:K_,envmap_physical_pars_fragment:a0,envmap_vertex:J_,fog_vertex:j_,fog_pars_vertex:Q_,fog_fragment:t0,fog_pars_fragment:e0,gradientmap_pars_fragment:n0,lightmap_pars_fragment:i0,lights_lambert_fragment:s0,lights_lambert_pars_fragment:r0,lights_pars_begin:o0,lights_toon_fragment:l0,lights_toon_pars_fragment:c0,lights_phong_fragment:h0,lights_phong_pars_fragment:u0,lights_physical_fragment:d0,lights_physical_pars_fragment:f0,lights_fragment_begin:p0,lights_fragment_maps:m0,lights_fragment_end:g0,lightprobes_pars_fragment:_0,logdepthbuf_fragment:x0,logdepthbuf_pars_fragment:y0,logdepthbuf_pars_vertex:v0,logdepthbuf_vertex:b0,map_fragment:S0,map_pars_fragment:M0,map_particle_fragment:w0,map_particle_pars_fragment:T0,metalnessmap_fragment:E0,metalnessmap_pars_fragment:A0,morphinstance_vertex:C0,morphcolor_vertex:R0,morphnormal_vertex:P0,morphtarget_pars_vertex:I0,morphtarget_vertex:L0,normal_fragment_begin:D0,normal_fragment_maps:N0,normal_pars_fragment:O0,normal_pars_vertex:U0,normal_vertex:F0,normalmap_pars_fragment:k0,clearcoat_normal_fragment_begin:B0,clearcoat_normal_fragment_maps:z0,clearcoat_pars_fragment:V0,iridescence_pars_fragment:G0,opaque_fragment:H0,packing:W0,premultiplied_alpha_fragment:X0,project_vertex:$0,dithering_fragment:q0,dithering_pars_fragment:Y0,roughnessmap_fragment:Z0,roughnessmap_pars_fragment:K0,shadowmap_pars_fragment:J0,shadowmap_pars_vertex:j0,shadowmap_vertex:Q0,shadowmask_pars_fragment:tx,skinbase_vertex:ex,skinning_pars_vertex:nx,skinning_vertex:ix,skinnormal_vertex:sx,specularmap_fragment:rx,specularmap_pars_fragment:ox,tonemapping_fragment:ax,tonemapping_pars_fragment:lx,transmission_fragment:cx,transmission_pars_fragment:hx,uv_pars_fragment:ux,uv_pars_vertex:dx,uv_vertex:fx,worldpos_vertex:px,background_vert:mx,background_frag:gx,backgroundCube_vert:_x,backgroundCube_frag:xx,cube_vert:yx,cube_frag:vx,depth_vert:bx,depth_frag:Sx,distance_vert:Mx,distance_frag:wx,equirect_vert:Tx,equirect_frag:Ex,linedashed_vert:Ax,linedashed_frag:Cx,meshbasic_vert:Rx,meshbasic_frag:Px,meshlambert_vert:Ix,meshlambert_frag:Lx,meshmatcap_vert:Dx,meshmatcap_frag:Nx,meshnormal_vert:Ox,meshnormal_frag:Ux,meshphong_vert:Fx,meshphong_frag:kx,meshphysical_vert:Bx,meshphysical_frag:zx,meshtoon_vert:Vx,meshtoon_frag:Gx,points_vert:Hx,points_frag:Wx,shadow_vert:Xx,shadow_frag:$x,sprite_vert:qx,sprite_frag:Yx},vt={common:{diffuse:{value:new kt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ft}},envmap:{envMap:{value:null},envMapRotation:{value:new Ft},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ft}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ft}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ft},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ft},normalScale:{value:new Mt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ft},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ft}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ft}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ft}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new kt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new kt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0},uvTransform:{value:new Ft}},sprite:{diffuse:{value:new kt(16777215)},opacity:{value:1},center:{value:new Mt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}}},Vn={basic:{uniforms:qe([vt.common,vt.specularmap,vt.envmap,vt.aomap,vt.lightmap,vt.fog]),vertexShader:Wt.meshbasic_vert,fragmentShader:Wt.meshbasic_frag},lambert:{uniforms:qe([vt.common,vt.specularmap,vt.envmap,vt.aomap,vt.lightmap,vt.emissivemap,vt.bumpmap,vt.normalmap,vt.displacementmap,vt.fog,vt.lights,{emissive:{value:new kt(0)},envMapIntensity:{value:1}}]),vertexShader:Wt.meshlambert_vert,fragmentShader:Wt.meshlambert_frag},phong:{uniforms:qe([vt.common,vt.specularmap,vt.envmap,vt.aomap,vt.lightmap,vt.emissivemap,vt.bumpmap,vt.normalmap,vt.displacementmap,vt.fog,vt.lights,{emissive:{value:new kt(0)},specular:{value:new kt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Wt.meshphong_vert,fragmentShader:Wt.meshphong_frag},standard:{uniforms:qe([vt.common,vt.envmap,vt.aomap,vt.lightmap,vt.emissivemap,vt.bumpmap,vt.normalmap,vt.displacementmap,vt.roughnessmap,vt.metalnessmap,vt.fog,vt.lights,{emissive:{value:new kt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Wt.meshphysical_vert,fragmentShader:Wt.meshphysical_frag},toon:{uniforms:qe([vt.common,vt.aomap,vt.lightmap,vt.emissivemap,vt.bumpmap,vt.normalmap,vt.displacementmap,vt.gradientmap,vt.fog,vt.lights,{emissive:{value:new kt(0)}}]),vertexShader:Wt.meshtoon_vert,fragmentShader:Wt.meshtoon_frag},matcap:{uniforms:qe([vt.common,vt.bumpmap,vt.normalmap,vt.displacementmap,vt.fog,{matcap:{value:null}}]),vertexShader:Wt.meshmatcap_vert,fragmentShader:Wt.meshmatcap_frag},points:{uniforms:qe([vt.points,vt.fog]),vertexShader:Wt.points_vert,fragmentShader:Wt.points_frag},dashed:{uniforms:qe([vt.common,vt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Wt.linedashed_vert,fragmentShader:Wt.linedashed_frag},depth:{uniforms:qe([vt.common,vt.displacementmap]),vertexShader:Wt.depth_vert,fragmentShader:Wt.depth_frag},normal:{uniforms:qe([vt.common,vt.bumpmap,vt.normalmap,vt.displacementmap,{opacity:{value:1}}]),vertexShader:Wt.meshnormal_vert,fragmentShader:Wt.meshnormal_frag},sprite:{uniforms:qe([vt.sprite,vt.fog]),vertexShader:Wt.sprite_vert,fragmentShader:Wt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ft},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Wt.background_vert,fragmentShader:Wt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ft}},vertexShader:Wt.backgroundCube_vert,fragmentShader:Wt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Wt.cube_vert,fragmentShader:Wt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Wt.equirect_vert,fragmentShader:Wt.equirect_frag},distance:{uniforms:qe([vt.common,vt.displacementmap,{referencePosition:{value:new R},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Wt.distance_vert,fragmentShader:Wt.distance_frag},shadow:{uniforms:qe([vt.lights,vt.fog,{color:{value:new kt(0)},opacity:{value:1}}]),vertexShader:Wt.shadow_vert,fragmentShader:Wt.shadow_frag}};Vn.physical={uniforms:qe([Vn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ft},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ft},clearcoatNormalScale:{value:new Mt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ft},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ft},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ft},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ft},sheen:{value:0},sheenColor:{value:new kt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ft},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ft},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ft},transmissionSamplerSize:{value:new Mt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ft},attenuationDistance:{value:0},attenuationColor:{value:new kt(0)},specularColor:{value:new kt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ft},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ft},anisotropyVector:{value:new Mt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ft}}]),vertexShader:Wt.meshphysical_vert,fragmentShader:Wt.meshphysical_frag};var ml={r:0,b:0,g:0},Zx=new Qt,hp=new Ft;hp.set(-1,0,0,0,1,0,0,0,1);function Kx(i,t,e,n,s,r){let o=new kt(0),a=s===!0?0:1,l,c,h=null,f=0,u=null;function d(v){let w=v.isScene===!0?v.background:null;if(w&&w.isTexture){let M=v.backgroundBlurriness>0;w=t.get(w,M)}return w}function g(v){let w=!1,M=d(v);M===null?m(o,a):M&&M.isColor&&(m(M,1),w=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?e.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(v,w){let M=d(w);M&&M.isCubeTexture?(c===void 0&&(c=new ze(new Ms(1,1,1),new kn({name:"BackgroundCubeMaterial",uniforms:Hi(Vn.backgroundCube.uniforms),vertexShader:Vn.backgroundCube.vertexShader,fragmentShader:Vn.backgroundCube.fragmentShader,side:Je,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Zx.makeRotationFromEuler(w.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(hp),c.material.toneMapped=Kt.getTransfer(M.colorSpace)!==ie,(h!==M||f!==M.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,f=M.version,u=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new ze(new _r(2,2),new kn({name:"BackgroundMaterial",uniforms:Hi(Vn.background.uniforms),vertexShader:Vn.background.vertexShader,fragmentShader:Vn.background.fragmentShader,side:wi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Kt.getTransfer(M.colorSpace)!==ie,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||f!==M.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,f=M.version,u=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,w){v.getRGB(ml,Ah(i)),e.buffers.color.setClear(ml.r,ml.g,ml.b,w,r)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,w=1){o.set(v),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:g,addToRenderList:x,dispose:_}}function Jx(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(O,B,H,D,Y){let J=!1,X=f(O,D,H,B);r!==X&&(r=X,c(r.object)),J=d(O,D,H,Y),J&&g(O,D,H,Y),Y!==null&&t.update(Y,i.ELEMENT_ARRAY_BUFFER),(J||o)&&(o=!1,M(O,B,H,D),Y!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(Y).buffer))}function l(){return i.createVertexArray()}function c(O){return i.bindVertexArray(O)}function h(O){return i.deleteVertexArray(O)}function f(O,B,H,D){let Y=D.wireframe===!0,J=n[B.id];J===void 0&&(J={},n[B.id]=J);let X=O.isInstancedMesh===!0?O.id:0,nt=J[X];nt===void 0&&(nt={},J[X]=nt);let q=nt[H.id];q===void 0&&(q={},nt[H.id]=q);let k=q[Y];return k===void 0&&(k=u(l()),q[Y]=k),k}function u(O){let B=[],H=[],D=[];for(let Y=0;Y<e;Y++)B[Y]=0,H[Y]=0,D[Y]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:H,attributeDivisors:D,object:O,attributes:{},index:null}}function d(O,B,H,D){let Y=r.attributes,J=B.attributes,X=0,nt=H.getAttributes();for(let q in nt)if(nt[q].location>=0){let Z=Y[q],dt=J[q];if(dt===void 0&&(q==="instanceMatrix"&&O.instanceMatrix&&(dt=O.instanceMatrix),q==="instanceColor"&&O.instanceColor&&(dt=O.instanceColor)),Z===void 0||Z.attribute!==dt||dt&&Z.data!==dt.data)return!0;X++}return r.attributesNum!==X||r.index!==D}function g(O,B,H,D){let Y={},J=B.attributes,X=0,nt=H.getAttributes();for(let q in nt)if(nt[q].location>=0){let Z=J[q];Z===void 0&&(q==="instanceMatrix"&&O.instanceMatrix&&(Z=O.instanceMatrix),q==="instanceColor"&&O.instanceColor&&(Z=O.instanceColor));let dt={};dt.attribute=Z,Z&&Z.data&&(dt.data=Z.data),Y[q]=dt,X++}r.attributes=Y,r.attributesNum=X,r.index=D}function x(){let O=r.newAttributes;for(let B=0,H=O.length;B<H;B++)O[B]=0}function m(O){_(O,0)}function _(O,B){let H=r.newAttributes,D=r.enabledAttributes,Y=r.attributeDivisors;H[O]=1,D[O]===0&&(i.enableVertexAttribArray(O),D[O]=1),Y[O]!==B&&(i.vertexAttribDivisor(O,B),Y[O]=B)}function v(){let O=r.newAttributes,B=r.enabledAttributes;for(let H=0,D=B.length;H<D;H++)B[H]!==O[H]&&(i.disableVertexAttribArray(H),B[H]=0)}function w(O,B,H,D,Y,J,X){X===!0?i.vertexAttribIPointer(O,B,H,Y,J):i.vertexAttribPointer(O,B,H,D,Y,J)}function M(O,B,H,D){x();let Y=D.attributes,J=H.getAttributes(),X=B.defaultAttributeValues;for(let nt in J){let q=J[nt];if(q.location>=0){let k=Y[nt];if(k===void 0&&(nt==="instanceMatrix"&&O.instanceMatrix&&(k=O.instanceMatrix),nt==="instanceColor"&&O.instanceColor&&(k=O.instanceColor)),k!==void 0){let Z=k.normalized,dt=k.itemSize,at=t.get(k);if(at===void 0)continue;let W=at.buffer,it=at.type,ct=at.bytesPerElement,St=it===i.INT||it===i.UNSIGNED_INT||k.gpuType===La;if(k.isInterleavedBufferAttribute){let lt=k.data,Lt=lt.isInterleavedBuffer===!0?lt.stride:lt.itemSize,xe=k.offset;if(lt.isInstancedInterleavedBuffer||lt.isInstancedBufferAttribute){for(let Dt=0;Dt<q.locationSize;Dt++)_(q.location+Dt,lt.meshPerAttribute);O.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=lt.meshPerAttribute*lt.count)}else for(let Dt=0;Dt<q.locationSize;Dt++)m(q.location+Dt);i.bindBuffer(i.ARRAY_BUFFER,W);for(let Dt=0;Dt<q.locationSize;Dt++)w(q.location+Dt,dt/q.locationSize,it,Z,Lt*ct,(xe+dt/q.locationSize*Dt)*ct,St)}else{if(k.isInstancedBufferAttribute){for(let lt=0;lt<q.locationSize;lt++)_(q.location+lt,k.meshPerAttribute);O.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=k.meshPerAttribute*k.count)}else for(let lt=0;lt<q.locationSize;lt++)m(q.location+lt);i.bindBuffer(i.ARRAY_BUFFER,W);for(let lt=0;lt<q.locationSize;lt++)w(q.location+lt,dt/q.locationSize,it,Z,dt*ct,dt/q.locationSize*lt*ct,St)}}else if(X!==void 0){let Z=X[nt];if(Z!==void 0)switch(Z.length){case 2:i.vertexAttrib2fv(q.location,Z);break;case 3:i.vertexAttrib3fv(q.location,Z);break;case 4:i.vertexAttrib4fv(q.location,Z);break;default:i.vertexAttrib1fv(q.location,Z)}}}}v()}function P(){U();for(let O in n){let B=n[O];for(let H in B){let D=B[H];for(let Y in D){let J=D[Y];for(let X in J)h(J[X].object),delete J[X];delete D[Y]}}delete n[O]}}function C(O){if(n[O.id]===void 0)return;let B=n[O.id];for(let H in B){let D=B[H];for(let Y in D){let J=D[Y];for(let X in J)h(J[X].object),delete J[X];delete D[Y]}}delete n[O.id]}function y(O){for(let B in n){let H=n[B];for(let D in H){let Y=H[D];if(Y[O.id]===void 0)continue;let J=Y[O.id];for(let X in J)h(J[X].object),delete J[X];delete Y[O.id]}}}function T(O){for(let B in n){let H=n[B],D=O.isInstancedMesh===!0?O.id:0,Y=H[D];if(Y!==void 0){for(let J in Y){let X=Y[J];for(let nt in X)h(X[nt].object),delete X[nt];delete Y[J]}delete H[D],Object.keys(H).length===0&&delete n[B]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:T,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:m,disableUnusedAttributes:v}}function jx(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let d=0;d<h;d++)u+=c[d];e.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Qx(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ln&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let T=y===In&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==en&&y!==Pn&&!T&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Pt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Pt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Pt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),_=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),w=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),C=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:m,maxAttributes:_,maxVertexUniforms:v,maxVaryings:w,maxFragmentUniforms:M,maxSamples:P,samples:C}}function ty(i){let t=this,e=null,n=0,s=!1,r=!1,o=new hn,a=new Ft,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,u){let d=f.length!==0||u||n!==0||s;return s=u,n=f.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,u){e=h(f,u,0)},this.setState=function(f,u,d){let g=f.clippingPlanes,x=f.clipIntersection,m=f.clipShadows,_=i.get(f);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let v=r?0:n,w=v*4,M=_.clippingState||null;l.value=M,M=h(g,u,w,d);for(let P=0;P!==w;++P)M[P]=e[P];_.clippingState=M,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(f,u,d,g){let x=f!==null?f.length:0,m=null;if(x!==0){if(m=l.value,g!==!0||m===null){let _=d+x*4,v=u.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<_)&&(m=new Float32Array(_));for(let w=0,M=d;w!==x;++w,M+=4)o.copy(f[w]).applyMatrix4(v,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var Br=class extends dn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new dr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ms(5,5,5),r=new kn({name:"CubemapFromEquirect",uniforms:Hi(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Je,blending:Bi});r.uniforms.tEquirect.value=e;let o=new ze(s,r),a=e.minFilter;return e.minFilter===Qn&&(e.minFilter=Ke),new As(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Gf=256,ey=3,ny=20,up=256,dp=16,iy=3,sy=new R,ry=new kt,_l=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new As(1,10,null),this._boxMesh=new ze(new Ms(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=sy}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,u=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(ry));let m=new As(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=f,l.autoClearColor=u,l.autoClearDepth=d,l.autoClearStencil=g,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Xf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Wf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Gf,Mh(t))}_fromTexture(t,e){t.mapping===Vi||t.mapping===Is?this._setSize(t.image.length===0?Gf:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Hf(t,!1,!1),n=Math.log2(t)-ey;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Hf(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Vi||t.mapping===Is?(this._cubemapMaterial===null&&(this._cubemapMaterial=Xf()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Wf()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=oy(),this._integrationMaterial=ay());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/dp);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-iy)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(up*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=ly());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Hf(i,t,e){return new Br(i,{minFilter:Qn,generateMipmaps:t,type:In,colorSpace:rr,depthBuffer:e})}function zr(i,t,e){return new kn({name:i,uniforms:t,vertexShader:Wt.cube_vert,fragmentShader:e,side:Je,blending:Bi,depthTest:!1,depthWrite:!1})}function oy(){return zr("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${up}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ay(){return zr("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:dp}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ly(){return zr("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ny}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Wf(){return zr("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Xf(){return zr("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function cy(i){let t=new WeakMap,e=new WeakMap,n=null;function s(u,d=!1){return u==null?null:d?o(u):r(u)}function r(u){if(u&&u.isTexture){let d=u.mapping;if(d===Ra||d===Pa)if(t.has(u)){let g=t.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let x=new Br(g.height);return x.fromEquirectangularTexture(i,u),t.set(u,x),u.addEventListener("dispose",c),a(x.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let d=u.mapping,g=d===Ra||d===Pa,x=d===Vi||d===Is;if(g||x){let m=e.get(u),_=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==_)return n===null&&(n=new _l(i)),m=g?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{let v=u.image;return g&&v&&v.height>0||x&&v&&l(v)?(n===null&&(n=new _l(i)),m=g?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,d){return d===Ra?u.mapping=Vi:d===Pa&&(u.mapping=Is),u}function l(u){let d=0,g=6;for(let x=0;x<g;x++)u[x]!==void 0&&d++;return d===g}function c(u){let d=u.target;d.removeEventListener("dispose",c);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function h(u){let d=u.target;d.removeEventListener("dispose",h);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function hy(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Qs("WebGLRenderer: "+n+" extension not supported."),s}}}function uy(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(t.remove(x),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(g){let x=g.attributes;for(let m in x)t.update(x[m],i.ARRAY_BUFFER)}function f(g){let x=g.index,m=g.attributes.position,_=0;if(m===void 0)return;let v=x!==null?x.array.length:m.array.length/3-1,w=m.count>=65535?ur:hr,M=new w(Math.ceil(v/3)*6,1),P=M.array;if(x!==null){let y=x.array;_=x.version;for(let T=0,U=0;T<v;T+=3){let L=y[T+0],O=y[T+1],B=y[T+2];P[U++]=L,P[U++]=O,P[U++]=O,P[U++]=B,P[U++]=B,P[U++]=L}}else{_=m.version;for(let y=0,T=0;y<v;y+=3){let U=y+0,L=y+1,O=y+2;P[T++]=U,P[T++]=L,P[T++]=L,P[T++]=O,P[T++]=O,P[T++]=U}}M.version=_;let C=r.get(g);C&&t.remove(C),r.set(g,M)}function u(g){let x=r.get(g);if(x){let m=g.index;m!==null&&x.version<m.version&&f(g)}else f(g);return r.get(g)}function d(){for(let g in s){let x=s[g].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:u,dispose:d}}function dy(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,u){i.drawElements(n,u,r,f*o),e.update(u,n,1)}function c(f,u,d){d!==0&&(i.drawElementsInstanced(n,u,r,f*o,d),e.update(u,n,d))}function h(f,u,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,f,0,d);let x=0;for(let m=0;m<d;m++)x+=u[m];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function fy(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:Nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function py(i,t,e){let n=new WeakMap,s=new _e;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==f){let U=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",U)};u!==void 0&&u.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],_=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],w=0;d===!0&&(w=1),g===!0&&(w=2),x===!0&&(w=3);let M=a.attributes.position.count*w,P=1;M>t.maxTextureSize&&(P=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let C=new Float32Array(M*P*4*f),y=new lr(C,M,P,f);y.type=Pn,y.needsUpdate=!0;let T=w*4;for(let L=0;L<f;L++){let O=m[L],B=_[L],H=v[L],D=M*P*4*L;for(let Y=0;Y<O.count;Y++){let J=Y*T;d===!0&&(s.fromBufferAttribute(O,Y),C[D+J+0]=s.x,C[D+J+1]=s.y,C[D+J+2]=s.z,C[D+J+3]=0),g===!0&&(s.fromBufferAttribute(B,Y),C[D+J+4]=s.x,C[D+J+5]=s.y,C[D+J+6]=s.z,C[D+J+7]=0),x===!0&&(s.fromBufferAttribute(H,Y),C[D+J+8]=s.x,C[D+J+9]=s.y,C[D+J+10]=s.z,C[D+J+11]=H.itemSize===4?s.w:1)}}u={count:f,texture:y,size:new Mt(M,P)},n.set(a,u),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let x=0;x<c.length;x++)d+=c[x];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function my(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,f=c.geometry,u=t.get(c,f);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var gy={[nh]:"LINEAR_TONE_MAPPING",[ih]:"REINHARD_TONE_MAPPING",[sh]:"CINEON_TONE_MAPPING",[rh]:"ACES_FILMIC_TONE_MAPPING",[ah]:"AGX_TONE_MAPPING",[lh]:"NEUTRAL_TONE_MAPPING",[oh]:"CUSTOM_TONE_MAPPING"};function _y(i,t,e,n,s,r){let o=new dn(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new $e;h.setAttribute("position",new pe([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new pe([0,2,0,0,2,0],2));let f=new fa({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new ze(h,f),d=new ki(-1,1,1,-1,0,1),g=null,x=null,m=!1,_,v=null,w=[],M=!1;this.setSize=function(P,C){o.setSize(P,C),a!==null&&a.setSize(P,C),l!==null&&l.setSize(P,C);for(let y=0;y<w.length;y++){let T=w[y];T.setSize&&T.setSize(P,C)}},this.setEffects=function(P){w=P,M=w.length>0&&w[0].isRenderPass===!0;let C=o.width,y=o.height;w.length>0&&a===null&&(a=new dn(C,y,{type:In,depthBuffer:!1,stencilBuffer:!1}),l=new dn(C,y,{type:In,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&w.some(U=>U.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new jn(C,y),r===!0&&(c.format=ti,c.type=Gi)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let U=0;U<w.length;U++){let L=w[U];L.setSize&&L.setSize(C,y),T&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(P,C){if(m||P.toneMapping===Bn&&w.length===0)return!1;if(v=C,C!==null){let y=C.width,T=C.height;(o.width!==y||o.height!==T)&&this.setSize(y,T)}return M===!1&&P.setRenderTarget(o),_=P.toneMapping,P.toneMapping=Bn,!0},this.hasRenderPass=function(){return M},this.end=function(P,C){P.toneMapping=_,m=!0;let y=o,T=a;for(let U=0;U<w.length;U++){let L=w[U];L.enabled!==!1&&(L.render(P,T,y,C),L.needsSwap!==!1&&(y=T,T=T===a?l:a))}if(g!==P.outputColorSpace||x!==P.toneMapping){g=P.outputColorSpace,x=P.toneMapping,f.defines={},Kt.getTransfer(g)===ie&&(f.defines.SRGB_TRANSFER="");let U=gy[x];U&&(f.defines[U]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=y.texture,P.setRenderTarget(v),P.render(u,d),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),f.dispose()}}var fp=new tn,pp=new jn(1,1),mp=new fr(1),gp=new lr,_p=new Qo,xp=new dr,$f=[],qf=[],Yf=new Float32Array(16),Zf=new Float32Array(9),Kf=new Float32Array(4);function Os(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=$f[s];if(r===void 0&&(r=new Float32Array(s),$f[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Ae(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Ce(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function yl(i,t){let e=qf[t];e===void 0&&(e=new Int32Array(t),qf[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function xy(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function yy(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;i.uniform2fv(this.addr,t),Ce(e,t)}}function vy(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Ae(e,t))return;i.uniform3fv(this.addr,t),Ce(e,t)}}function by(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;i.uniform4fv(this.addr,t),Ce(e,t)}}function Sy(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Ae(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Ce(e,t)}else{if(Ae(e,n))return;Kf.set(n),i.uniformMatrix2fv(this.addr,!1,Kf),Ce(e,n)}}function My(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Ae(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Ce(e,t)}else{if(Ae(e,n))return;Zf.set(n),i.uniformMatrix3fv(this.addr,!1,Zf),Ce(e,n)}}function wy(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Ae(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Ce(e,t)}else{if(Ae(e,n))return;Yf.set(n),i.uniformMatrix4fv(this.addr,!1,Yf),Ce(e,n)}}function Ty(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Ey(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;i.uniform2iv(this.addr,t),Ce(e,t)}}function Ay(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ae(e,t))return;i.uniform3iv(this.addr,t),Ce(e,t)}}function Cy(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;i.uniform4iv(this.addr,t),Ce(e,t)}}function Ry(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Py(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;i.uniform2uiv(this.addr,t),Ce(e,t)}}function Iy(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ae(e,t))return;i.uniform3uiv(this.addr,t),Ce(e,t)}}function Ly(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;i.uniform4uiv(this.addr,t),Ce(e,t)}}function vl(i){return i.version===0&&(i.compareFunction=yh,i.needsUpdate=!0),i}function Dy(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=vl(pp):r=fp,e.setTexture2D(t||r,s)}function Ny(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||_p,s)}function Oy(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=vl(mp):r=xp,e.setTextureCube(t||r,s)}function Uy(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||gp,s)}function Fy(i){switch(i){case 5126:return xy;case 35664:return yy;case 35665:return vy;case 35666:return by;case 35674:return Sy;case 35675:return My;case 35676:return wy;case 5124:case 35670:return Ty;case 35667:case 35671:return Ey;case 35668:case 35672:return Ay;case 35669:case 35673:return Cy;case 5125:return Ry;case 36294:return Py;case 36295:return Iy;case 36296:return Ly;case 35678:case 36198:case 36298:case 36306:case 35682:return Dy;case 35679:case 36299:case 36307:return Ny;case 35680:case 36300:case 36308:case 36293:return Oy;case 36289:case 36303:case 36311:case 36292:return Uy}}function ky(i,t){i.uniform1fv(this.addr,t)}function By(i,t){let e=Os(t,this.size,2);i.uniform2fv(this.addr,e)}function zy(i,t){let e=Os(t,this.size,3);i.uniform3fv(this.addr,e)}function Vy(i,t){let e=Os(t,this.size,4);i.uniform4fv(this.addr,e)}function Gy(i,t){let e=Os(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Hy(i,t){let e=Os(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Wy(i,t){let e=Os(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Xy(i,t){i.uniform1iv(this.addr,t)}function $y(i,t){i.uniform2iv(this.addr,t)}function qy(i,t){i.uniform3iv(this.addr,t)}function Yy(i,t){i.uniform4iv(this.addr,t)}function Zy(i,t){i.uniform1uiv(this.addr,t)}function Ky(i,t){i.uniform2uiv(this.addr,t)}function Jy(i,t){i.uniform3uiv(this.addr,t)}function jy(i,t){i.uniform4uiv(this.addr,t)}function Qy(i,t,e){let n=this.cache,s=t.length,r=yl(e,s);Ae(n,r)||(i.uniform1iv(this.addr,r),Ce(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=vl(pp):o=fp;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function tv(i,t,e){let n=this.cache,s=t.length,r=yl(e,s);Ae(n,r)||(i.uniform1iv(this.addr,r),Ce(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||_p,r[o])}function ev(i,t,e){let n=this.cache,s=t.length,r=yl(e,s);Ae(n,r)||(i.uniform1iv(this.addr,r),Ce(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=vl(mp):o=xp;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function nv(i,t,e){let n=this.cache,s=t.length,r=yl(e,s);Ae(n,r)||(i.uniform1iv(this.addr,r),Ce(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||gp,r[o])}function iv(i){switch(i){case 5126:return ky;case 35664:return By;case 35665:return zy;case 35666:return Vy;case 35674:return Gy;case 35675:return Hy;case 35676:return Wy;case 5124:case 35670:return Xy;case 35667:case 35671:return $y;case 35668:case 35672:return qy;case 35669:case 35673:return Yy;case 5125:return Zy;case 36294:return Ky;case 36295:return Jy;case 36296:return jy;case 35678:case 36198:case 36298:case 36306:case 35682:return Qy;case 35679:case 36299:case 36307:return tv;case 35680:case 36300:case 36308:case 36293:return ev;case 36289:case 36303:case 36311:case 36292:return nv}}var Dh=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Fy(e.type)}},Nh=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=iv(e.type)}},Oh=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Ih=/(\w+)(\])?(\[|\.)?/g;function Jf(i,t){i.seq.push(t),i.map[t.id]=t}function sv(i,t,e){let n=i.name,s=n.length;for(Ih.lastIndex=0;;){let r=Ih.exec(n),o=Ih.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Jf(e,c===void 0?new Dh(a,i,t):new Nh(a,i,t));break}else{let f=e.map[a];f===void 0&&(f=new Oh(a),Jf(e,f)),e=f}}}var Ns=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);sv(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function jf(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var rv=37297,ov=0;function av(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Qf=new Ft;function lv(i){Kt._getMatrix(Qf,Kt.workingColorSpace,i);let t=`mat3( ${Qf.elements.map(e=>e.toFixed(4))} )`;switch(Kt.getTransfer(i)){case or:return[t,"LinearTransferOETF"];case ie:return[t,"sRGBTransferOETF"];default:return Pt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function tp(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+av(i.getShaderSource(t),a)}else return r}function cv(i,t){let e=lv(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var hv={[nh]:"Linear",[ih]:"Reinhard",[sh]:"Cineon",[rh]:"ACESFilmic",[ah]:"AgX",[lh]:"Neutral",[oh]:"Custom"};function uv(i,t){let e=hv[t];return e===void 0?(Pt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var gl=new R;function dv(){Kt.getLuminanceCoefficients(gl);let i=gl.x.toFixed(4),t=gl.y.toFixed(4),e=gl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function fv(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(kr).join(`
`)}function pv(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function mv(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function kr(i){return i!==""}function ep(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function np(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var gv=/^[ \t]*#include +<([\w\d./]+)>/gm;function Uh(i){return i.replace(gv,_v)}function _v(i,t){let e=Wt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Uh(e)}var xv=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function ip(i){return i.replace(xv,yv)}function yv(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function sp(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var vv={[Rr]:"SHADOWMAP_TYPE_PCF",[Rs]:"SHADOWMAP_TYPE_VSM"};function bv(i){return vv[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Sv={[Is]:"ENVMAP_MODE_REFRACTION"};function Mv(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Sv[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var wv={[Ca]:"ENVMAP_BLENDING_MULTIPLY",[vf]:"ENVMAP_BLENDING_MIX",[bf]:"ENVMAP_BLENDING_ADD"};function Tv(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":wv[i.combine]||"ENVMAP_BLENDING_NONE"}function Ev(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=bv(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Mv(e),f=Tv(e),u=fv(e),d=pv(r),g=s.createProgram(),x,m,_=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(kr).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(kr).join(`
`),m.length>0&&(m+=`
`)):(x=[sp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(kr).join(`
`),m=[sp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Bn?"#define TONE_MAPPING":"",e.toneMapping!==Bn?Wt.tonemapping_pars_fragment:"",e.toneMapping!==Bn?uv("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Wt.colorspace_pars_fragment,cv("linearToOutputTexel",e.outputColorSpace),dv(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(kr).join(`
`)),o=Uh(o),o=ep(o,e),o=np(o,e),a=Uh(a),a=ep(a,e),a=np(a,e),o=ip(o),a=ip(a),e.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===vh?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===vh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=_+x+o,w=_+m+a,M=jf(s,s.VERTEX_SHADER,v),P=jf(s,s.FRAGMENT_SHADER,w);s.attachShader(g,M),s.attachShader(g,P),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function C(L){if(i.debug.checkShaderErrors){let O=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(M)||"",H=s.getShaderInfoLog(P)||"",D=O.trim(),Y=B.trim(),J=H.trim(),X=!0,nt=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(X=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,M,P);else{let q=tp(s,M,"vertex"),k=tp(s,P,"fragment");Nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+D+`
`+q+`
`+k)}else D!==""?Pt("WebGLProgram: Program Info Log:",D):(Y===""||J==="")&&(nt=!1);nt&&(L.diagnostics={runnable:X,programLog:D,vertexShader:{log:Y,prefix:x},fragmentShader:{log:J,prefix:m}})}s.deleteShader(M),s.deleteShader(P),y=new Ns(s,g),T=mv(s,g)}let y;this.getUniforms=function(){return y===void 0&&C(this),y};let T;this.getAttributes=function(){return T===void 0&&C(this),T};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,rv)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=ov++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=P,this}var Av=0,Fh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new kh(t),e.set(t,n)),n}},kh=class{constructor(t){this.id=Av++,this.code=t,this.usedTimes=0}};function Cv(i){return i===Ti||i===Or||i===Ur}function Rv(i,t,e,n,s,r){let o=new vs,a=new Fh,l=new Set,c=[],h=new Map,f=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return l.add(y),y===0?"uv":`uv${y}`}function g(y,T,U,L,O,B){let H=L.fog,D=O.geometry,Y=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,J=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,X=t.get(y.envMap||Y,J),nt=u[y.type],q=n.precision;y.precision!==null&&(q=n.getMaxPrecision(y.precision),q!==y.precision&&Pt("WebGLProgram.getParameters:",y.precision,"not supported, using",q,"instead."));let k=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,Z=k!==void 0?k.length:0,dt=0;D.morphAttributes.position!==void 0&&(dt=1),D.morphAttributes.normal!==void 0&&(dt=2),D.morphAttributes.color!==void 0&&(dt=3);let at,W,it,ct;if(nt){let yt=Vn[nt];at=yt.vertexShader,W=yt.fragmentShader}else{at=y.vertexShader,W=y.fragmentShader;let yt=a.getVertexShaderStage(y),re=a.getFragmentShaderStage(y);a.update(y,yt,re),it=yt.id,ct=re.id}let St=i.getRenderTarget(),lt=i.state.buffers.depth.getReversed(),Lt=O.isInstancedMesh===!0,xe=O.isBatchedMesh===!0,Dt=!!y.map,se=!!y.matcap,ce=!!X,$t=ce&&X.isPMREMTexture===!0,Fe=!!y.aoMap,we=!!y.lightMap,je=!!y.bumpMap&&y.wireframe===!1,ye=!!y.normalMap,Dn=!!y.displacementMap,Pe=!!y.emissiveMap,mn=!!y.metalnessMap,gn=!!y.roughnessMap,_n=y.anisotropy>0,F=y.clearcoat>0,xn=y.diffuseRoughness>0,me=y.dispersion>0,ge=y.retroreflectivity>0,xt=y.iridescence>0,Te=y.sheen>0,It=y.transmission>0,Bt=_n&&!!y.anisotropyMap,A=F&&!!y.clearcoatMap,b=F&&!!y.clearcoatNormalMap,V=F&&!!y.clearcoatRoughnessMap,st=xn&&!!y.diffuseRoughnessMap,et=xt&&!!y.iridescenceMap,ht=xt&&!!y.iridescenceThicknessMap,gt=Te&&!!y.sheenColorMap,j=Te&&!!y.sheenRoughnessMap,Q=!!y.specularMap,ft=!!y.specularColorMap,I=!!y.specularIntensityMap,tt=It&&!!y.transmissionMap,K=It&&!!y.thicknessMap,pt=!!y.gradientMap,ot=!!y.alphaMap,ut=y.alphaTest>0,Ct=!!y.alphaHash,Ht=!!y.extensions,rt=Bn;y.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(rt=i.toneMapping);let Rt=$t?X.isCompressedCubeTexture?X.image[0].mipmaps:X.mipmaps:null,Vt={shaderID:nt,shaderType:y.type,shaderName:y.name,vertexShader:at,fragmentShader:W,defines:y.defines,customVertexShaderID:it,customFragmentShaderID:ct,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:q,batching:xe,batchingColor:xe&&O._colorsTexture!==null,instancing:Lt,instancingColor:Lt&&O.instanceColor!==null,instancingMorph:Lt&&O.morphTexture!==null,outputColorSpace:St===null?i.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:Kt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Dt,matcap:se,envMap:ce,envMapMode:ce&&X.mapping,envMapPMREM:$t,envMapMaxLod:$t?Rt.length-1:null,envMapSize:$t?Rt[0].width:null,aoMap:Fe,lightMap:we,bumpMap:je,normalMap:ye,displacementMap:Dn,emissiveMap:Pe,normalMapObjectSpace:ye&&y.normalMapType===wf,normalMapTangentSpace:ye&&y.normalMapType===pl,packedNormalMap:ye&&y.normalMapType===pl&&Cv(y.normalMap.format),metalnessMap:mn,roughnessMap:gn,anisotropy:_n,anisotropyMap:Bt,clearcoat:F,clearcoatMap:A,clearcoatNormalMap:b,clearcoatRoughnessMap:V,diffuseRoughness:xn,diffuseRoughnessMap:st,dispersion:me,retroreflection:ge,iridescence:xt,iridescenceMap:et,iridescenceThicknessMap:ht,sheen:Te,sheenColorMap:gt,sheenRoughnessMap:j,specularMap:Q,specularColorMap:ft,specularIntensityMap:I,transmission:It,transmissionMap:tt,thicknessMap:K,gradientMap:pt,opaque:y.transparent===!1&&y.blending===Ps&&y.alphaToCoverage===!1,alphaMap:ot,alphaTest:ut,alphaHash:Ct,combine:y.combine,mapUv:Dt&&d(y.map.channel),aoMapUv:Fe&&d(y.aoMap.channel),lightMapUv:we&&d(y.lightMap.channel),bumpMapUv:je&&d(y.bumpMap.channel),normalMapUv:ye&&d(y.normalMap.channel),displacementMapUv:Dn&&d(y.displacementMap.channel),emissiveMapUv:Pe&&d(y.emissiveMap.channel),metalnessMapUv:mn&&d(y.metalnessMap.channel),roughnessMapUv:gn&&d(y.roughnessMap.channel),anisotropyMapUv:Bt&&d(y.anisotropyMap.channel),clearcoatMapUv:A&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:b&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:V&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:st&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:et&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:ht&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:gt&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:j&&d(y.sheenRoughnessMap.channel),specularMapUv:Q&&d(y.specularMap.channel),specularColorMapUv:ft&&d(y.specularColorMap.channel),specularIntensityMapUv:I&&d(y.specularIntensityMap.channel),transmissionMapUv:tt&&d(y.transmissionMap.channel),thicknessMapUv:K&&d(y.thicknessMap.channel),alphaMapUv:ot&&d(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(ye||_n),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!D.attributes.uv&&(Dt||ot),fog:!!H,useFog:y.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&ye===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:lt,skinning:O.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:Z,morphTextureStride:dt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:B.filter(yt=>yt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:rt,decodeVideoTexture:Dt&&y.map.isVideoTexture===!0&&Kt.getTransfer(y.map.colorSpace)===ie,decodeVideoTextureEmissive:Pe&&y.emissiveMap.isVideoTexture===!0&&Kt.getTransfer(y.emissiveMap.colorSpace)===ie,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===pn,flipSided:y.side===Je,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Ht&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ht&&y.extensions.multiDraw===!0||xe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Vt.vertexUv1s=l.has(1),Vt.vertexUv2s=l.has(2),Vt.vertexUv3s=l.has(3),l.clear(),Vt}function x(y){let T=[];if(y.shaderID?T.push(y.shaderID):(T.push(y.customVertexShaderID),T.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)T.push(U),T.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(m(T,y),_(T,y),T.push(i.outputColorSpace)),T.push(y.customProgramCacheKey),T.join()}function m(y,T){y.push(T.precision),y.push(T.outputColorSpace),y.push(T.envMapMode),y.push(T.envMapPMREM),y.push(T.envMapMaxLod),y.push(T.envMapSize),y.push(T.mapUv),y.push(T.alphaMapUv),y.push(T.lightMapUv),y.push(T.aoMapUv),y.push(T.bumpMapUv),y.push(T.normalMapUv),y.push(T.displacementMapUv),y.push(T.emissiveMapUv),y.push(T.metalnessMapUv),y.push(T.roughnessMapUv),y.push(T.anisotropyMapUv),y.push(T.clearcoatMapUv),y.push(T.clearcoatNormalMapUv),y.push(T.clearcoatRoughnessMapUv),y.push(T.diffuseRoughnessMapUv),y.push(T.iridescenceMapUv),y.push(T.iridescenceThicknessMapUv),y.push(T.sheenColorMapUv),y.push(T.sheenRoughnessMapUv),y.push(T.specularMapUv),y.push(T.specularColorMapUv),y.push(T.specularIntensityMapUv),y.push(T.transmissionMapUv),y.push(T.thicknessMapUv),y.push(T.combine),y.push(T.fogExp2),y.push(T.sizeAttenuation),y.push(T.morphTargetsCount),y.push(T.numSunLights),y.push(T.numDirLights),y.push(T.numPointLights),y.push(T.numSpotLights),y.push(T.numSpotLightMaps),y.push(T.numHemiLights),y.push(T.numRectAreaLights),y.push(T.numSunLightShadows),y.push(T.numDirLightShadows),y.push(T.numPointLightShadows),y.push(T.numSpotLightShadows),y.push(T.numSpotLightShadowsWithMaps),y.push(T.numLightProbes),y.push(T.numLightProbeGrids),y.push(T.shadowMapType),y.push(T.toneMapping),y.push(T.numClippingPlanes),y.push(T.numClipIntersection),y.push(T.depthPacking)}function _(y,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function v(y){let T=u[y.type],U;if(T){let L=Vn[T];U=Bf.clone(L.uniforms)}else U=y.uniforms;return U}function w(y,T){let U=h.get(T);return U!==void 0?++U.usedTimes:(U=new Ev(i,T,y,s),c.push(U),h.set(T,U)),U}function M(y){if(--y.usedTimes===0){let T=c.indexOf(y);c[T]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function P(y){a.remove(y)}function C(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:v,acquireProgram:w,releaseProgram:M,releaseShaderCache:P,programs:c,dispose:C}}function Pv(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Iv(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function rp(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function op(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u){let d=0;return u.isInstancedMesh&&(d+=2),u.isSkinnedMesh&&(d+=1),d}function a(u,d,g,x,m,_){let v=i[t];return v===void 0?(v={id:u.id,object:u,geometry:d,material:g,materialVariant:o(u),groupOrder:x,renderOrder:u.renderOrder,z:m,group:_},i[t]=v):(v.id=u.id,v.object=u,v.geometry=d,v.material=g,v.materialVariant=o(u),v.groupOrder=x,v.renderOrder=u.renderOrder,v.z=m,v.group=_),t++,v}function l(u,d,g,x,m,_,v){v.reversedDepth===!0&&(m=-m);let w=a(u,d,g,x,m,_);g.transmission>0?n.push(w):g.transparent===!0?s.push(w):e.push(w)}function c(u,d,g,x,m,_){let v=a(u,d,g,x,m,_);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):e.unshift(v)}function h(u,d){e.length>1&&e.sort(u||Iv),n.length>1&&n.sort(d||rp),s.length>1&&s.sort(d||rp)}function f(){for(let u=t,d=i.length;u<d;u++){let g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:f,sort:h}}function Lv(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new op,i.set(n,[o])):s>=r.length?(o=new op,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function Dv(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new R,color:new kt};break;case"SpotLight":e={position:new R,direction:new R,color:new kt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new R,color:new kt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new R,skyColor:new kt,groundColor:new kt};break;case"RectAreaLight":e={color:new kt,position:new R,halfWidth:new R,halfHeight:new R};break}return i[t.id]=e,e}}}function Nv(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Mt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Mt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Mt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Ov=0;function Uv(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Fv(i){let t=new Dv,e=Nv(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new R);let s=new R,r=new Qt,o=new Qt;function a(c){let h=0,f=0,u=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let d=0,g=0,x=0,m=0,_=0,v=0,w=0,M=0,P=0,C=0,y=0,T=0,U=0,L=0;c.sort(Uv);for(let B=0,H=c.length;B<H;B++){let D=c[B],Y=D.color,J=D.intensity,X=D.distance,nt=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Ti?nt=D.shadow.map.texture:nt=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=Y.r*J,f+=Y.g*J,u+=Y.b*J;else if(D.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(D.sh.coefficients[q],J);L++}else if(D.isSunLight){let q=t.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let k=D.shadow,Z=e.get(D);Z.shadowIntensity=k.intensity,Z.shadowBias=k.bias,Z.shadowNormalBias=k.normalBias,Z.shadowRadius=k.radius,Z.shadowMapSize.copy(k.mapSize).multiply(k.getFrameExtents()),n.sunShadow[g]=Z,n.sunShadowMap[g]=nt;let dt=k.getViewportCount();for(let at=0;at<dt;at++)n.sunShadowMatrix[x+at]=k.getMatrix(at),n.sunShadowCascade[x+at]=k._cascadeData[at];x+=dt,g++}n.sun[d]=q,d++}else if(D.isDirectionalLight){let q=t.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let k=D.shadow,Z=e.get(D);Z.shadowIntensity=k.intensity,Z.shadowBias=k.bias,Z.shadowNormalBias=k.normalBias,Z.shadowRadius=k.radius,Z.shadowMapSize=k.mapSize,n.directionalShadow[m]=Z,n.directionalShadowMap[m]=nt,n.directionalShadowMatrix[m]=D.shadow.matrix,P++}n.directional[m]=q,m++}else if(D.isSpotLight){let q=t.get(D);q.position.setFromMatrixPosition(D.matrixWorld),q.color.copy(Y).multiplyScalar(J),q.distance=X,q.coneCos=Math.cos(D.angle),q.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),q.decay=D.decay,n.spot[v]=q;let k=D.shadow;if(D.map&&(n.spotLightMap[T]=D.map,T++,k.updateMatrices(D),D.castShadow&&U++),n.spotLightMatrix[v]=k.matrix,D.castShadow){let Z=e.get(D);Z.shadowIntensity=k.intensity,Z.shadowBias=k.bias,Z.shadowNormalBias=k.normalBias,Z.shadowRadius=k.radius,Z.shadowMapSize=k.mapSize,n.spotShadow[v]=Z,n.spotShadowMap[v]=nt,y++}v++}else if(D.isRectAreaLight){let q=t.get(D);q.color.copy(Y).multiplyScalar(J),q.halfWidth.set(D.width*.5,0,0),q.halfHeight.set(0,D.height*.5,0),n.rectArea[w]=q,w++}else if(D.isPointLight){let q=t.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),q.distance=D.distance,q.decay=D.decay,D.castShadow){let k=D.shadow,Z=e.get(D);Z.shadowIntensity=k.intensity,Z.shadowBias=k.bias,Z.shadowNormalBias=k.normalBias,Z.shadowRadius=k.radius,Z.shadowMapSize=k.mapSize,Z.shadowCameraNear=k.camera.near,Z.shadowCameraFar=k.camera.far,n.pointShadow[_]=Z,n.pointShadowMap[_]=nt,n.pointShadowMatrix[_]=D.shadow.matrix,C++}n.point[_]=q,_++}else if(D.isHemisphereLight){let q=t.get(D);q.skyColor.copy(D.color).multiplyScalar(J),q.groundColor.copy(D.groundColor).multiplyScalar(J),n.hemi[M]=q,M++}}w>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=vt.LTC_FLOAT_1,n.rectAreaLTC2=vt.LTC_FLOAT_2):(n.rectAreaLTC1=vt.LTC_HALF_1,n.rectAreaLTC2=vt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=u;let O=n.hash;(O.sunLength!==d||O.directionalLength!==m||O.pointLength!==_||O.spotLength!==v||O.rectAreaLength!==w||O.hemiLength!==M||O.numSunShadows!==g||O.numDirectionalShadows!==P||O.numPointShadows!==C||O.numSpotShadows!==y||O.numSpotMaps!==T||O.numLightProbes!==L)&&(n.sun.length=d,n.directional.length=m,n.spot.length=v,n.rectArea.length=w,n.point.length=_,n.hemi.length=M,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=C,n.pointShadowMap.length=C,n.pointShadowMatrix.length=C,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+T-U,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=L,O.sunLength=d,O.directionalLength=m,O.pointLength=_,O.spotLength=v,O.rectAreaLength=w,O.hemiLength=M,O.numSunShadows=g,O.numDirectionalShadows=P,O.numPointShadows=C,O.numSpotShadows=y,O.numSpotMaps=T,O.numLightProbes=L,n.version=Ov++)}function l(c,h){let f=0,u=0,d=0,g=0,x=0,m=0,_=h.matrixWorldInverse;for(let v=0,w=c.length;v<w;v++){let M=c[v];if(M.isSunLight){let P=n.sun[f];P.direction.setFromMatrixPosition(M.matrixWorld),P.direction.transformDirection(_),f++}else if(M.isDirectionalLight){let P=n.directional[u];P.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(_),u++}else if(M.isSpotLight){let P=n.spot[g];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(_),P.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(_),g++}else if(M.isRectAreaLight){let P=n.rectArea[x];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(_),o.identity(),r.copy(M.matrixWorld),r.premultiply(_),o.extractRotation(r),P.halfWidth.set(M.width*.5,0,0),P.halfHeight.set(0,M.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),x++}else if(M.isPointLight){let P=n.point[d];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(_),d++}else if(M.isHemisphereLight){let P=n.hemi[m];P.direction.setFromMatrixPosition(M.matrixWorld),P.direction.transformDirection(_),m++}}}return{setup:a,setupView:l,state:n}}function ap(i){let t=new Fv(i),e=[],n=[],s=[];function r(f){h.camera=f,e.length=0,n.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):e.push(f)}function a(f){n.push(f)}function l(){t.setup(e),s.sort((f,u)=>f.priority-u.priority||f.id-u.id)}function c(f){t.setupView(e,f)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function kv(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new ap(i),t.set(s,[a])):r>=o.length?(a=new ap(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var Bv=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,zv=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Vv=[new R(1,0,0),new R(-1,0,0),new R(0,1,0),new R(0,-1,0),new R(0,0,1),new R(0,0,-1)],Gv=[new R(0,-1,0),new R(0,-1,0),new R(0,0,1),new R(0,0,-1),new R(0,-1,0),new R(0,-1,0)],lp=new Qt,Fr=new R,Lh=new R;function Hv(i,t,e){let n=new gi,s=new Mt,r=new Mt,o=new _e,a=new pa,l=new ma,c={},h=e.maxTextureSize,f={[wi]:Je,[Je]:wi,[pn]:pn},u=new kn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Mt},radius:{value:4}},vertexShader:Bv,fragmentShader:zv}),d=u.clone();d.defines.HORIZONTAL_PASS=1;let g=new $e;g.setAttribute("position",new un(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new ze(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Rr;let _=this.type;this.render=function(C,y,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||C.length===0)return;this.type===tf&&(Pt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Rr);let U=i.getRenderTarget(),L=i.getActiveCubeFace(),O=i.getActiveMipmapLevel(),B=i.state;B.setBlending(Bi),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let H=_!==this.type;H&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(Y=>Y.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,Y=C.length;D<Y;D++){let J=C[D],X=J.shadow;if(X===void 0){Pt("WebGLShadowMap:",J,"has no shadow.");continue}if(X.autoUpdate===!1&&X.needsUpdate===!1)continue;s.copy(X.mapSize);let nt=X.getFrameExtents();s.multiply(nt),r.copy(X.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/nt.x),s.x=r.x*nt.x,X.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/nt.y),s.y=r.y*nt.y,X.mapSize.y=r.y));let q=i.state.buffers.depth.getReversed();if(X.camera._reversedDepth=q,X.map===null||H===!0){if(X.map!==null&&(X.map.depthTexture!==null&&(X.map.depthTexture.dispose(),X.map.depthTexture=null),X.map.dispose()),this.type===Rs){if(J.isPointLight){Pt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}X.map=new dn(s.x,s.y,{format:Ti,type:In,minFilter:Ke,magFilter:Ke,generateMipmaps:!1}),X.map.texture.name=J.name+".shadowMap",X.map.depthTexture=new jn(s.x,s.y,Pn),X.map.depthTexture.name=J.name+".shadowMapDepth",X.map.depthTexture.format=Zn,X.map.depthTexture.compareFunction=null,X.map.depthTexture.minFilter=Oe,X.map.depthTexture.magFilter=Oe}else J.isPointLight?(X.map=new Br(s.x),X.map.depthTexture=new fr(s.x,Rn)):(X.map=new dn(s.x,s.y),X.map.depthTexture=new jn(s.x,s.y,Rn)),X.map.depthTexture.name=J.name+".shadowMap",X.map.depthTexture.format=Zn,this.type===Rr?(X.map.depthTexture.compareFunction=q?xh:_h,X.map.depthTexture.minFilter=Ke,X.map.depthTexture.magFilter=Ke):(X.map.depthTexture.compareFunction=null,X.map.depthTexture.minFilter=Oe,X.map.depthTexture.magFilter=Oe);X.camera.updateProjectionMatrix()}X.map.isWebGLCubeRenderTarget!==!0&&(X.map.width!==s.x||X.map.height!==s.y)&&X.map.setSize(s.x,s.y);let k=X.map.isWebGLCubeRenderTarget?6:X.getViewportCount();J.isPointLight!==!0&&X.updateMatrices(J,T);let Z=(X.camera.layers.mask&4294967294)!==0?X.camera.layers:T.layers;for(let dt=0;dt<k;dt++){let at=X.getCamera(dt);if(J.isPointLight){let W=X.camera,it=X.matrix,ct=J.distance||W.far;ct!==W.far&&(W.far=ct,W.updateProjectionMatrix()),Fr.setFromMatrixPosition(J.matrixWorld),W.position.copy(Fr),Lh.copy(W.position),Lh.add(Vv[dt]),W.up.copy(Gv[dt]),W.lookAt(Lh),W.updateMatrixWorld(),it.makeTranslation(-Fr.x,-Fr.y,-Fr.z),lp.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),X._frustum.setFromProjectionMatrix(lp,W.coordinateSystem,W.reversedDepth)}if(X.map.isWebGLCubeRenderTarget)i.setRenderTarget(X.map,dt),i.clear();else{dt===0&&(i.setRenderTarget(X.map),i.clear());let W=X.getViewport(dt);o.set(r.x*W.x,r.y*W.y,r.x*W.z,r.y*W.w),B.viewport(o)}n=X.getFrustum(dt),M(y,T,at,J,Z,this.type)}X.isPointLightShadow!==!0&&this.type===Rs&&v(X,T),X.needsUpdate=!1}_=this.type,m.needsUpdate=!1,i.setRenderTarget(U,L,O)};function v(C,y){let T=t.update(x);u.defines.VSM_SAMPLES!==C.blurSamples&&(u.defines.VSM_SAMPLES=C.blurSamples,d.defines.VSM_SAMPLES=C.blurSamples,u.needsUpdate=!0,d.needsUpdate=!0),C.mapPass===null?C.mapPass=new dn(s.x,s.y,{format:Ti,type:In}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),u.uniforms.shadow_pass.value=C.map.depthTexture,u.uniforms.resolution.value.set(C.map.width,C.map.height),u.uniforms.radius.value=C.radius,i.setRenderTarget(C.mapPass),i.clear(),i.renderBufferDirect(y,null,T,u,x,null),d.uniforms.shadow_pass.value=C.mapPass.texture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,i.setRenderTarget(C.map),i.clear(),i.renderBufferDirect(y,null,T,d,x,null)}function w(C,y,T,U){let L=null,O=T.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(O!==void 0)L=O;else if(L=T.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let B=L.uuid,H=y.uuid,D=c[B];D===void 0&&(D={},c[B]=D);let Y=D[H];Y===void 0&&(Y=L.clone(),D[H]=Y,y.addEventListener("dispose",P)),L=Y}if(L.visible=y.visible,L.wireframe=y.wireframe,U===Rs?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:f[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,T.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let B=i.properties.get(L);B.light=T}return L}function M(C,y,T,U,L,O){if(C.visible===!1)return;if(C.layers.test(L)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&O===Rs)&&(!C.frustumCulled||C.intersectsFrustum(n))){C.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,C.matrixWorld);let D=t.update(C),Y=C.material;if(Array.isArray(Y)){let J=D.groups;for(let X=0,nt=J.length;X<nt;X++){let q=J[X],k=Y[q.materialIndex];if(k&&k.visible){let Z=w(C,k,U,O);C.onBeforeShadow(i,C,y,T,D,Z,q),i.renderBufferDirect(T,null,D,Z,C,q),C.onAfterShadow(i,C,y,T,D,Z,q)}}}else if(Y.visible){let J=w(C,Y,U,O);C.onBeforeShadow(i,C,y,T,D,J,null),i.renderBufferDirect(T,null,D,J,C,null),C.onAfterShadow(i,C,y,T,D,J,null)}}let H=C.children;for(let D=0,Y=H.length;D<Y;D++)M(H[D],y,T,U,L,O)}function P(C){C.target.removeEventListener("dispose",P);for(let T in c){let U=c[T],L=C.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function Wv(i,t){function e(){let I=!1,tt=new _e,K=null,pt=new _e(0,0,0,0);return{setMask:function(ot){K!==ot&&!I&&(i.colorMask(ot,ot,ot,ot),K=ot)},setLocked:function(ot){I=ot},setClear:function(ot,ut,Ct,Ht,rt){rt===!0&&(ot*=Ht,ut*=Ht,Ct*=Ht),tt.set(ot,ut,Ct,Ht),pt.equals(tt)===!1&&(i.clearColor(ot,ut,Ct,Ht),pt.copy(tt))},reset:function(){I=!1,K=null,pt.set(-1,0,0,0)}}}function n(){let I=!1,tt=!1,K=null,pt=null,ot=null;return{setReversed:function(ut){if(tt!==ut){let Ct=t.get("EXT_clip_control");ut?Ct.clipControlEXT(Ct.LOWER_LEFT_EXT,Ct.ZERO_TO_ONE_EXT):Ct.clipControlEXT(Ct.LOWER_LEFT_EXT,Ct.NEGATIVE_ONE_TO_ONE_EXT),tt=ut;let Ht=ot;ot=null,this.setClear(Ht)}},getReversed:function(){return tt},setTest:function(ut){ut?lt(i.DEPTH_TEST):Lt(i.DEPTH_TEST)},setMask:function(ut){K!==ut&&!I&&(i.depthMask(ut),K=ut)},setFunc:function(ut){if(tt&&(ut=Of[ut]),pt!==ut){switch(ut){case Vo:i.depthFunc(i.NEVER);break;case Go:i.depthFunc(i.ALWAYS);break;case Ho:i.depthFunc(i.LESS);break;case ms:i.depthFunc(i.LEQUAL);break;case Wo:i.depthFunc(i.EQUAL);break;case Xo:i.depthFunc(i.GEQUAL);break;case $o:i.depthFunc(i.GREATER);break;case qo:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}pt=ut}},setLocked:function(ut){I=ut},setClear:function(ut){ot!==ut&&(ot=ut,tt&&(ut=1-ut),i.clearDepth(ut))},reset:function(){I=!1,K=null,pt=null,ot=null,tt=!1}}}function s(){let I=!1,tt=null,K=null,pt=null,ot=null,ut=null,Ct=null,Ht=null,rt=null;return{setTest:function(Rt){I||(Rt?lt(i.STENCIL_TEST):Lt(i.STENCIL_TEST))},setMask:function(Rt){tt!==Rt&&!I&&(i.stencilMask(Rt),tt=Rt)},setFunc:function(Rt,Vt,yt){(K!==Rt||pt!==Vt||ot!==yt)&&(i.stencilFunc(Rt,Vt,yt),K=Rt,pt=Vt,ot=yt)},setOp:function(Rt,Vt,yt){(ut!==Rt||Ct!==Vt||Ht!==yt)&&(i.stencilOp(Rt,Vt,yt),ut=Rt,Ct=Vt,Ht=yt)},setLocked:function(Rt){I=Rt},setClear:function(Rt){rt!==Rt&&(i.clearStencil(Rt),rt=Rt)},reset:function(){I=!1,tt=null,K=null,pt=null,ot=null,ut=null,Ct=null,Ht=null,rt=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},f={},u={},d=new WeakMap,g=[],x=null,m=!1,_=null,v=null,w=null,M=null,P=null,C=null,y=null,T=new kt(0,0,0),U=0,L=!1,O=null,B=null,H=null,D=null,Y=null,J=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),X=!1,nt=0,q=i.getParameter(i.VERSION);q.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec(q)[1]),X=nt>=1):q.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),X=nt>=2);let k=null,Z={},dt=i.getParameter(i.SCISSOR_BOX),at=i.getParameter(i.VIEWPORT),W=new _e().fromArray(dt),it=new _e().fromArray(at);function ct(I,tt,K,pt){let ot=new Uint8Array(4),ut=i.createTexture();i.bindTexture(I,ut),i.texParameteri(I,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(I,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ct=0;Ct<K;Ct++)I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY?i.texImage3D(tt,0,i.RGBA,1,1,pt,0,i.RGBA,i.UNSIGNED_BYTE,ot):i.texImage2D(tt+Ct,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ot);return ut}let St={};St[i.TEXTURE_2D]=ct(i.TEXTURE_2D,i.TEXTURE_2D,1),St[i.TEXTURE_CUBE_MAP]=ct(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[i.TEXTURE_2D_ARRAY]=ct(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),St[i.TEXTURE_3D]=ct(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),lt(i.DEPTH_TEST),o.setFunc(ms),je(!1),ye(Kc),lt(i.CULL_FACE),Fe(Bi);function lt(I){h[I]!==!0&&(i.enable(I),h[I]=!0)}function Lt(I){h[I]!==!1&&(i.disable(I),h[I]=!1)}function xe(I,tt){return u[I]!==tt?(i.bindFramebuffer(I,tt),u[I]=tt,I===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=tt),I===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=tt),!0):!1}function Dt(I,tt){let K=g,pt=!1;if(I){K=d.get(tt),K===void 0&&(K=[],d.set(tt,K));let ot=I.textures;if(K.length!==ot.length||K[0]!==i.COLOR_ATTACHMENT0){for(let ut=0,Ct=ot.length;ut<Ct;ut++)K[ut]=i.COLOR_ATTACHMENT0+ut;K.length=ot.length,pt=!0}}else K[0]!==i.BACK&&(K[0]=i.BACK,pt=!0);pt&&i.drawBuffers(K)}function se(I){return x!==I?(i.useProgram(I),x=I,!0):!1}let ce={[zi]:i.FUNC_ADD,[nf]:i.FUNC_SUBTRACT,[sf]:i.FUNC_REVERSE_SUBTRACT};ce[rf]=i.MIN,ce[of]=i.MAX;let $t={[af]:i.ZERO,[lf]:i.ONE,[cf]:i.SRC_COLOR,[th]:i.SRC_ALPHA,[mf]:i.SRC_ALPHA_SATURATE,[ff]:i.DST_COLOR,[uf]:i.DST_ALPHA,[hf]:i.ONE_MINUS_SRC_COLOR,[eh]:i.ONE_MINUS_SRC_ALPHA,[pf]:i.ONE_MINUS_DST_COLOR,[df]:i.ONE_MINUS_DST_ALPHA,[gf]:i.CONSTANT_COLOR,[_f]:i.ONE_MINUS_CONSTANT_COLOR,[xf]:i.CONSTANT_ALPHA,[yf]:i.ONE_MINUS_CONSTANT_ALPHA};function Fe(I,tt,K,pt,ot,ut,Ct,Ht,rt,Rt){if(I===Bi){m===!0&&(Lt(i.BLEND),m=!1);return}if(m===!1&&(lt(i.BLEND),m=!0),I!==ef){if(I!==_||Rt!==L){if((v!==zi||P!==zi)&&(i.blendEquation(i.FUNC_ADD),v=zi,P=zi),Rt)switch(I){case Ps:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Jc:i.blendFunc(i.ONE,i.ONE);break;case jc:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Qc:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Nt("WebGLState: Invalid blending: ",I);break}else switch(I){case Ps:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Jc:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case jc:Nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Qc:Nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Nt("WebGLState: Invalid blending: ",I);break}w=null,M=null,C=null,y=null,T.set(0,0,0),U=0,_=I,L=Rt}return}ot=ot||tt,ut=ut||K,Ct=Ct||pt,(tt!==v||ot!==P)&&(i.blendEquationSeparate(ce[tt],ce[ot]),v=tt,P=ot),(K!==w||pt!==M||ut!==C||Ct!==y)&&(i.blendFuncSeparate($t[K],$t[pt],$t[ut],$t[Ct]),w=K,M=pt,C=ut,y=Ct),(Ht.equals(T)===!1||rt!==U)&&(i.blendColor(Ht.r,Ht.g,Ht.b,rt),T.copy(Ht),U=rt),_=I,L=!1}function we(I,tt){I.side===pn?Lt(i.CULL_FACE):lt(i.CULL_FACE);let K=I.side===Je;tt&&(K=!K),je(K),I.blending===Ps&&I.transparent===!1?Fe(Bi):Fe(I.blending,I.blendEquation,I.blendSrc,I.blendDst,I.blendEquationAlpha,I.blendSrcAlpha,I.blendDstAlpha,I.blendColor,I.blendAlpha,I.premultipliedAlpha),o.setFunc(I.depthFunc),o.setTest(I.depthTest),o.setMask(I.depthWrite),r.setMask(I.colorWrite);let pt=I.stencilWrite;a.setTest(pt),pt&&(a.setMask(I.stencilWriteMask),a.setFunc(I.stencilFunc,I.stencilRef,I.stencilFuncMask),a.setOp(I.stencilFail,I.stencilZFail,I.stencilZPass)),Pe(I.polygonOffset,I.polygonOffsetFactor,I.polygonOffsetUnits),I.alphaToCoverage===!0?lt(i.SAMPLE_ALPHA_TO_COVERAGE):Lt(i.SAMPLE_ALPHA_TO_COVERAGE)}function je(I){O!==I&&(I?i.frontFace(i.CW):i.frontFace(i.CCW),O=I)}function ye(I){I!==jd?(lt(i.CULL_FACE),I!==B&&(I===Kc?i.cullFace(i.BACK):I===Qd?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Lt(i.CULL_FACE),B=I}function Dn(I){I!==H&&(X&&i.lineWidth(I),H=I)}function Pe(I,tt,K){I?(lt(i.POLYGON_OFFSET_FILL),(D!==tt||Y!==K)&&(D=tt,Y=K,o.getReversed()&&(tt=-tt,K=-K),i.polygonOffset(tt,K))):Lt(i.POLYGON_OFFSET_FILL)}function mn(I){I?lt(i.SCISSOR_TEST):Lt(i.SCISSOR_TEST)}function gn(I){I===void 0&&(I=i.TEXTURE0+J-1),k!==I&&(i.activeTexture(I),k=I)}function _n(I,tt,K){K===void 0&&(k===null?K=i.TEXTURE0+J-1:K=k);let pt=Z[K];pt===void 0&&(pt={type:void 0,texture:void 0},Z[K]=pt),(pt.type!==I||pt.texture!==tt)&&(k!==K&&(i.activeTexture(K),k=K),i.bindTexture(I,tt||St[I]),pt.type=I,pt.texture=tt)}function F(){let I=Z[k];I!==void 0&&I.type!==void 0&&(i.bindTexture(I.type,null),I.type=void 0,I.texture=void 0)}function xn(){try{i.compressedTexImage2D(...arguments)}catch(I){Nt("WebGLState:",I)}}function me(){try{i.compressedTexImage3D(...arguments)}catch(I){Nt("WebGLState:",I)}}function ge(){try{i.texSubImage2D(...arguments)}catch(I){Nt("WebGLState:",I)}}function xt(){try{i.texSubImage3D(...arguments)}catch(I){Nt("WebGLState:",I)}}function Te(){try{i.compressedTexSubImage2D(...arguments)}catch(I){Nt("WebGLState:",I)}}function It(){try{i.compressedTexSubImage3D(...arguments)}catch(I){Nt("WebGLState:",I)}}function Bt(){try{i.texStorage2D(...arguments)}catch(I){Nt("WebGLState:",I)}}function A(){try{i.texStorage3D(...arguments)}catch(I){Nt("WebGLState:",I)}}function b(){try{i.texImage2D(...arguments)}catch(I){Nt("WebGLState:",I)}}function V(){try{i.texImage3D(...arguments)}catch(I){Nt("WebGLState:",I)}}function st(I){return f[I]!==void 0?f[I]:i.getParameter(I)}function et(I,tt){f[I]!==tt&&(i.pixelStorei(I,tt),f[I]=tt)}function ht(I){W.equals(I)===!1&&(i.scissor(I.x,I.y,I.z,I.w),W.copy(I))}function gt(I){it.equals(I)===!1&&(i.viewport(I.x,I.y,I.z,I.w),it.copy(I))}function j(I,tt){let K=c.get(tt);K===void 0&&(K=new WeakMap,c.set(tt,K));let pt=K.get(I);pt===void 0&&(pt=i.getUniformBlockIndex(tt,I.name),i.uniformBlockBinding(tt,pt,pt),K.set(I,pt))}function Q(I,tt,K){let ot=c.get(tt).get(I);l[ot]!==K&&(i.bindBufferBase(i.UNIFORM_BUFFER,ot,K),l[ot]=K)}function ft(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},f={},k=null,Z={},u={},l={},d=new WeakMap,g=[],x=null,m=!1,_=null,v=null,w=null,M=null,P=null,C=null,y=null,T=new kt(0,0,0),U=0,L=!1,O=null,B=null,H=null,D=null,Y=null,W.set(0,0,i.canvas.width,i.canvas.height),it.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:lt,disable:Lt,bindFramebuffer:xe,drawBuffers:Dt,useProgram:se,setBlending:Fe,setMaterial:we,setFlipSided:je,setCullFace:ye,setLineWidth:Dn,setPolygonOffset:Pe,setScissorTest:mn,activeTexture:gn,bindTexture:_n,unbindTexture:F,compressedTexImage2D:xn,compressedTexImage3D:me,texImage2D:b,texImage3D:V,pixelStorei:et,getParameter:st,updateUBOMapping:j,uniformBlockBinding:Q,texStorage2D:Bt,texStorage3D:A,texSubImage2D:ge,texSubImage3D:xt,compressedTexSubImage2D:Te,compressedTexSubImage3D:It,scissor:ht,viewport:gt,reset:ft}}function Xv(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Mt,h=new WeakMap,f=new Set,u,d=new WeakMap,g=new Set,x=new FinalizationRegistry(A=>g.delete(A)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(A,b){return m?new OffscreenCanvas(A,b):ar("canvas")}function v(A,b,V){let st=1,et=Bt(A);if((et.width>V||et.height>V)&&(st=V/Math.max(et.width,et.height)),st<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let ht=Math.floor(st*et.width),gt=Math.floor(st*et.height);u===void 0&&(u=_(ht,gt));let j=b?_(ht,gt):u;return j.width=ht,j.height=gt,j.getContext("2d").drawImage(A,0,0,ht,gt),Pt("WebGLRenderer: Texture has been resized from ("+et.width+"x"+et.height+") to ("+ht+"x"+gt+")."),j}else return"data"in A&&Pt("WebGLRenderer: Image in DataTexture is too big ("+et.width+"x"+et.height+")."),A;return A}function w(A){return A.generateMipmaps}function M(A){i.generateMipmap(A)}function P(A){return A.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?i.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function C(A,b,V,st,et,ht=!1){if(A!==null){if(i[A]!==void 0)return i[A];Pt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let gt;st&&(gt=t.get("EXT_texture_norm16"),gt||Pt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let j=b;if(b===i.RED&&(V===i.FLOAT&&(j=i.R32F),V===i.HALF_FLOAT&&(j=i.R16F),V===i.UNSIGNED_BYTE&&(j=i.R8),V===i.UNSIGNED_SHORT&&gt&&(j=gt.R16_EXT),V===i.SHORT&&gt&&(j=gt.R16_SNORM_EXT)),b===i.RED_INTEGER&&(V===i.UNSIGNED_BYTE&&(j=i.R8UI),V===i.UNSIGNED_SHORT&&(j=i.R16UI),V===i.UNSIGNED_INT&&(j=i.R32UI),V===i.BYTE&&(j=i.R8I),V===i.SHORT&&(j=i.R16I),V===i.INT&&(j=i.R32I)),b===i.RG&&(V===i.FLOAT&&(j=i.RG32F),V===i.HALF_FLOAT&&(j=i.RG16F),V===i.UNSIGNED_BYTE&&(j=i.RG8),V===i.UNSIGNED_SHORT&&gt&&(j=gt.RG16_EXT),V===i.SHORT&&gt&&(j=gt.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(V===i.UNSIGNED_BYTE&&(j=i.RG8UI),V===i.UNSIGNED_SHORT&&(j=i.RG16UI),V===i.UNSIGNED_INT&&(j=i.RG32UI),V===i.BYTE&&(j=i.RG8I),V===i.SHORT&&(j=i.RG16I),V===i.INT&&(j=i.RG32I)),b===i.RGB_INTEGER&&(V===i.UNSIGNED_BYTE&&(j=i.RGB8UI),V===i.UNSIGNED_SHORT&&(j=i.RGB16UI),V===i.UNSIGNED_INT&&(j=i.RGB32UI),V===i.BYTE&&(j=i.RGB8I),V===i.SHORT&&(j=i.RGB16I),V===i.INT&&(j=i.RGB32I)),b===i.RGBA_INTEGER&&(V===i.UNSIGNED_BYTE&&(j=i.RGBA8UI),V===i.UNSIGNED_SHORT&&(j=i.RGBA16UI),V===i.UNSIGNED_INT&&(j=i.RGBA32UI),V===i.BYTE&&(j=i.RGBA8I),V===i.SHORT&&(j=i.RGBA16I),V===i.INT&&(j=i.RGBA32I)),b===i.RGB&&(V===i.UNSIGNED_SHORT&&gt&&(j=gt.RGB16_EXT),V===i.SHORT&&gt&&(j=gt.RGB16_SNORM_EXT),V===i.UNSIGNED_INT_5_9_9_9_REV&&(j=i.RGB9_E5),V===i.UNSIGNED_INT_10F_11F_11F_REV&&(j=i.R11F_G11F_B10F)),b===i.RGBA){let Q=ht?or:Kt.getTransfer(et);V===i.FLOAT&&(j=i.RGBA32F),V===i.HALF_FLOAT&&(j=i.RGBA16F),V===i.UNSIGNED_BYTE&&(j=Q===ie?i.SRGB8_ALPHA8:i.RGBA8),V===i.UNSIGNED_SHORT&&gt&&(j=gt.RGBA16_EXT),V===i.SHORT&&gt&&(j=gt.RGBA16_SNORM_EXT),V===i.UNSIGNED_SHORT_4_4_4_4&&(j=i.RGBA4),V===i.UNSIGNED_SHORT_5_5_5_1&&(j=i.RGB5_A1)}return(j===i.R16F||j===i.R32F||j===i.RG16F||j===i.RG32F||j===i.RGBA16F||j===i.RGBA32F)&&t.get("EXT_color_buffer_float"),j}function y(A,b){let V;return A?b===null||b===Rn||b===Gi?V=i.DEPTH24_STENCIL8:b===Pn?V=i.DEPTH32F_STENCIL8:b===Ls&&(V=i.DEPTH24_STENCIL8,Pt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Rn||b===Gi?V=i.DEPTH_COMPONENT24:b===Pn?V=i.DEPTH_COMPONENT32F:b===Ls&&(V=i.DEPTH_COMPONENT16),V}function T(A,b){return w(A)===!0||A.isFramebufferTexture&&A.minFilter!==Oe&&A.minFilter!==Ke?Math.log2(Math.max(b.width,b.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?b.mipmaps.length:1}function U(A){let b=new WeakRef(A);n.get(A).__ref=b,g.add(b),x.register(A,b,b)}function L(A){let b=n.get(A).__ref;b!==void 0&&(g.delete(b),x.unregister(b))}function O(A){H(A.target)}function B(A){D(A.target)}function H(A){A.removeEventListener("dispose",O),L(A),J(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&f.delete(A)}function D(A){A.removeEventListener("dispose",B),L(A),nt(A)}function Y(){for(let A of g){let b=A.deref();b!==void 0&&(b.isRenderTarget===!0?D(b):H(b))}g.clear(),f.clear()}function J(A){let b=n.get(A);if(b.__webglInit===void 0)return;let V=A.source,st=d.get(V);if(st){let et=st[b.__cacheKey];et.usedTimes--,et.usedTimes===0&&X(A),Object.keys(st).length===0&&d.delete(V)}n.remove(A)}function X(A){let b=n.get(A);i.deleteTexture(b.__webglTexture);let V=A.source,st=d.get(V);delete st[b.__cacheKey],o.memory.textures--}function nt(A){let b=n.get(A);b.__depthDisposeCallback&&b.__depthDisposeCallback();let V=A.depthTexture;if(V&&V.renderTarget===A&&H(V),A.isWebGLCubeRenderTarget)for(let et=0;et<6;et++){if(Array.isArray(b.__webglFramebuffer[et]))for(let ht=0;ht<b.__webglFramebuffer[et].length;ht++)i.deleteFramebuffer(b.__webglFramebuffer[et][ht]);else i.deleteFramebuffer(b.__webglFramebuffer[et]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[et])}else{if(Array.isArray(b.__webglFramebuffer))for(let et=0;et<b.__webglFramebuffer.length;et++)i.deleteFramebuffer(b.__webglFramebuffer[et]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let et=0;et<b.__webglColorRenderbuffer.length;et++)b.__webglColorRenderbuffer[et]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[et]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let st=A.textures;for(let et=0,ht=st.length;et<ht;et++){let gt=n.get(st[et]);gt.__webglTexture&&(i.deleteTexture(gt.__webglTexture),o.memory.textures--),n.remove(st[et])}n.remove(A)}let q=0;function k(){q=0}function Z(){return q}function dt(A){q=A}function at(){let A=q;return A>=s.maxTextures&&Pt("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,A}function W(A){let b=[];return b.push(A.wrapS),b.push(A.wrapT),b.push(A.wrapR||0),b.push(A.magFilter),b.push(A.minFilter),b.push(A.anisotropy),b.push(A.internalFormat),b.push(A.format),b.push(A.type),b.push(A.generateMipmaps),b.push(A.mipmapsAutoUpdate),b.push(A.premultiplyAlpha),b.push(A.flipY),b.push(A.unpackAlignment),b.push(A.colorSpace),b.join()}function it(A,b){let V=n.get(A);if(A.isVideoTexture&&Te(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&V.__version!==A.version){let st=A.image;if(st===null)Pt("WebGLRenderer: Texture marked for update but no image data found.");else if(st.complete===!1)Pt("WebGLRenderer: Texture marked for update but image is incomplete");else{we(V,A,b);return}}else A.isExternalTexture&&(V.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,V.__webglTexture,i.TEXTURE0+b)}function ct(A,b){let V=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&V.__version!==A.version){we(V,A,b);return}else A.isExternalTexture&&(V.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,V.__webglTexture,i.TEXTURE0+b)}function St(A,b){let V=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&V.__version!==A.version){we(V,A,b);return}e.bindTexture(i.TEXTURE_3D,V.__webglTexture,i.TEXTURE0+b)}function lt(A,b){let V=n.get(A);if(A.version>0&&V.__version!==A.version){je(V,A,b);return}e.bindTexture(i.TEXTURE_CUBE_MAP,V.__webglTexture,i.TEXTURE0+b)}let Lt={[Yo]:i.REPEAT,[Un]:i.CLAMP_TO_EDGE,[Zo]:i.MIRRORED_REPEAT},xe={[Oe]:i.NEAREST,[Sf]:i.NEAREST_MIPMAP_NEAREST,[Pr]:i.NEAREST_MIPMAP_LINEAR,[Ke]:i.LINEAR,[Ia]:i.LINEAR_MIPMAP_NEAREST,[Qn]:i.LINEAR_MIPMAP_LINEAR},Dt={[Ef]:i.NEVER,[yh]:i.ALWAYS,[Af]:i.LESS,[_h]:i.LEQUAL,[Cf]:i.EQUAL,[xh]:i.GEQUAL,[Rf]:i.GREATER,[Pf]:i.NOTEQUAL};function se(A,b){if(b.type===Pn&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===Ke||b.magFilter===Ia||b.magFilter===Pr||b.magFilter===Qn||b.minFilter===Ke||b.minFilter===Ia||b.minFilter===Pr||b.minFilter===Qn)&&Pt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(A,i.TEXTURE_WRAP_S,Lt[b.wrapS]),i.texParameteri(A,i.TEXTURE_WRAP_T,Lt[b.wrapT]),(A===i.TEXTURE_3D||A===i.TEXTURE_2D_ARRAY)&&i.texParameteri(A,i.TEXTURE_WRAP_R,Lt[b.wrapR]),i.texParameteri(A,i.TEXTURE_MAG_FILTER,xe[b.magFilter]),i.texParameteri(A,i.TEXTURE_MIN_FILTER,xe[b.minFilter]),b.compareFunction&&(i.texParameteri(A,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(A,i.TEXTURE_COMPARE_FUNC,Dt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Oe||b.minFilter!==Pr&&b.minFilter!==Qn||b.type===Pn&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let V=t.get("EXT_texture_filter_anisotropic");i.texParameterf(A,V.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function ce(A,b){let V=!1;A.__webglInit===void 0&&(A.__webglInit=!0,b.addEventListener("dispose",O),U(b));let st=b.source,et=d.get(st);et===void 0&&(et={},d.set(st,et));let ht=W(b);if(ht!==A.__cacheKey){et[ht]===void 0&&(et[ht]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,V=!0),et[ht].usedTimes++;let gt=et[A.__cacheKey];gt!==void 0&&(et[A.__cacheKey].usedTimes--,gt.usedTimes===0&&X(b)),A.__cacheKey=ht,A.__webglTexture=et[ht].texture}return V}function $t(A,b,V){return Math.floor(Math.floor(A/V)/b)}function Fe(A,b,V,st){let ht=A.updateRanges;if(ht.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,V,st,b.data);else{ht.sort((I,tt)=>I.start-tt.start);let gt=0;for(let I=1;I<ht.length;I++){let tt=ht[gt],K=ht[I],pt=tt.start+tt.count,ot=$t(K.start,b.width,4),ut=$t(tt.start,b.width,4);K.start<=pt+1&&ot===ut&&$t(K.start+K.count-1,b.width,4)===ot?tt.count=Math.max(tt.count,K.start+K.count-tt.start):(++gt,ht[gt]=K)}ht.length=gt+1;let j=e.getParameter(i.UNPACK_ROW_LENGTH),Q=e.getParameter(i.UNPACK_SKIP_PIXELS),ft=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let I=0,tt=ht.length;I<tt;I++){let K=ht[I],pt=Math.floor(K.start/4),ot=Math.ceil(K.count/4),ut=pt%b.width,Ct=Math.floor(pt/b.width),Ht=ot,rt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,ut),e.pixelStorei(i.UNPACK_SKIP_ROWS,Ct),e.texSubImage2D(i.TEXTURE_2D,0,ut,Ct,Ht,rt,V,st,b.data)}A.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,j),e.pixelStorei(i.UNPACK_SKIP_PIXELS,Q),e.pixelStorei(i.UNPACK_SKIP_ROWS,ft)}}function we(A,b,V){let st=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(st=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(st=i.TEXTURE_3D);let et=ce(A,b),ht=b.source;e.bindTexture(st,A.__webglTexture,i.TEXTURE0+V);let gt=n.get(ht);if(ht.version!==gt.__version||et===!0){if(e.activeTexture(i.TEXTURE0+V),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let rt=Kt.getPrimaries(Kt.workingColorSpace),Rt=b.colorSpace===ei?null:Kt.getPrimaries(b.colorSpace),Vt=b.colorSpace===ei||rt===Rt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Vt)}e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let Q=v(b.image,!1,s.maxTextureSize);Q=It(b,Q);let ft=r.convert(b.format,b.colorSpace),I=r.convert(b.type),tt=C(b.internalFormat,ft,I,b.normalized,b.colorSpace,b.isVideoTexture);se(st,b);let K,pt=b.mipmaps,ot=b.isVideoTexture!==!0,ut=gt.__version===void 0||et===!0,Ct=ht.dataReady,Ht=T(b,Q);if(b.isDepthTexture)tt=y(b.format===ti,b.type),ut&&(ot?e.texStorage2D(i.TEXTURE_2D,1,tt,Q.width,Q.height):e.texImage2D(i.TEXTURE_2D,0,tt,Q.width,Q.height,0,ft,I,null));else if(b.isDataTexture)if(pt.length>0){ot&&ut&&e.texStorage2D(i.TEXTURE_2D,Ht,tt,pt[0].width,pt[0].height);for(let rt=0,Rt=pt.length;rt<Rt;rt++)K=pt[rt],ot?Ct&&e.texSubImage2D(i.TEXTURE_2D,rt,0,0,K.width,K.height,ft,I,K.data):e.texImage2D(i.TEXTURE_2D,rt,tt,K.width,K.height,0,ft,I,K.data);b.generateMipmaps=!1}else ot?(ut&&e.texStorage2D(i.TEXTURE_2D,Ht,tt,Q.width,Q.height),Ct&&Fe(b,Q,ft,I)):e.texImage2D(i.TEXTURE_2D,0,tt,Q.width,Q.height,0,ft,I,Q.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){ot&&ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ht,tt,pt[0].width,pt[0].height,Q.depth);for(let rt=0,Rt=pt.length;rt<Rt;rt++)if(K=pt[rt],b.format!==Ln)if(ft!==null)if(ot){if(Ct)if(b.layerUpdates.size>0){let Vt=Ph(K.width,K.height,b.format,b.type);for(let yt of b.layerUpdates){let re=K.data.subarray(yt*Vt/K.data.BYTES_PER_ELEMENT,(yt+1)*Vt/K.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,rt,0,0,yt,K.width,K.height,1,ft,re)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,rt,0,0,0,K.width,K.height,Q.depth,ft,K.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,rt,tt,K.width,K.height,Q.depth,0,K.data,0,0);else Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ot?Ct&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,rt,0,0,0,K.width,K.height,Q.depth,ft,I,K.data):e.texImage3D(i.TEXTURE_2D_ARRAY,rt,tt,K.width,K.height,Q.depth,0,ft,I,K.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{ot&&ut&&e.texStorage2D(i.TEXTURE_2D,Ht,tt,pt[0].width,pt[0].height);for(let rt=0,Rt=pt.length;rt<Rt;rt++)K=pt[rt],b.format!==Ln?ft!==null?ot?Ct&&e.compressedTexSubImage2D(i.TEXTURE_2D,rt,0,0,K.width,K.height,ft,K.data):e.compressedTexImage2D(i.TEXTURE_2D,rt,tt,K.width,K.height,0,K.data):Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ot?Ct&&e.texSubImage2D(i.TEXTURE_2D,rt,0,0,K.width,K.height,ft,I,K.data):e.texImage2D(i.TEXTURE_2D,rt,tt,K.width,K.height,0,ft,I,K.data)}else if(b.isDataArrayTexture)if(ot){if(ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ht,tt,Q.width,Q.height,Q.depth),Ct)if(b.layerUpdates.size>0){let rt=Ph(Q.width,Q.height,b.format,b.type);for(let Rt of b.layerUpdates){let Vt=Q.data.subarray(Rt*rt/Q.data.BYTES_PER_ELEMENT,(Rt+1)*rt/Q.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Rt,Q.width,Q.height,1,ft,I,Vt)}b.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Q.width,Q.height,Q.depth,ft,I,Q.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,tt,Q.width,Q.height,Q.depth,0,ft,I,Q.data);else if(b.isData3DTexture)ot?(ut&&e.texStorage3D(i.TEXTURE_3D,Ht,tt,Q.width,Q.height,Q.depth),Ct&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Q.width,Q.height,Q.depth,ft,I,Q.data)):e.texImage3D(i.TEXTURE_3D,0,tt,Q.width,Q.height,Q.depth,0,ft,I,Q.data);else if(b.isFramebufferTexture){if(ut)if(ot)e.texStorage2D(i.TEXTURE_2D,Ht,tt,Q.width,Q.height);else{let rt=Q.width,Rt=Q.height;for(let Vt=0;Vt<Ht;Vt++)e.texImage2D(i.TEXTURE_2D,Vt,tt,rt,Rt,0,ft,I,null),rt>>=1,Rt>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let rt=i.canvas;if(rt.hasAttribute("layoutsubtree")||rt.setAttribute("layoutsubtree","true"),Q.parentNode!==rt){rt.appendChild(Q),f.add(b),rt.onpaint=Rt=>{let Vt=Rt.changedElements;for(let yt of f)Vt.includes(yt.image)&&(yt.needsUpdate=!0)},rt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Q);else{let Vt=i.RGBA,yt=i.RGBA,re=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Vt,yt,re,Q)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(pt.length>0){if(ot&&ut){let rt=Bt(pt[0]);e.texStorage2D(i.TEXTURE_2D,Ht,tt,rt.width,rt.height)}for(let rt=0,Rt=pt.length;rt<Rt;rt++)K=pt[rt],ot?Ct&&e.texSubImage2D(i.TEXTURE_2D,rt,0,0,ft,I,K):e.texImage2D(i.TEXTURE_2D,rt,tt,ft,I,K);b.generateMipmaps=!1}else if(ot){if(ut){let rt=Bt(Q);e.texStorage2D(i.TEXTURE_2D,Ht,tt,rt.width,rt.height)}Ct&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ft,I,Q)}else e.texImage2D(i.TEXTURE_2D,0,tt,ft,I,Q);w(b)&&b.mipmapsAutoUpdate===!0&&M(st),gt.__version=ht.version,b.onUpdate&&b.onUpdate(b)}A.__version=b.version}function je(A,b,V){if(b.image.length!==6)return;let st=ce(A,b),et=b.source;e.bindTexture(i.TEXTURE_CUBE_MAP,A.__webglTexture,i.TEXTURE0+V);let ht=n.get(et);if(et.version!==ht.__version||st===!0){e.activeTexture(i.TEXTURE0+V);let gt=Kt.getPrimaries(Kt.workingColorSpace),j=b.colorSpace===ei?null:Kt.getPrimaries(b.colorSpace),Q=b.colorSpace===ei||gt===j?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Q);let ft=b.isCompressedTexture||b.image[0].isCompressedTexture,I=b.image[0]&&b.image[0].isDataTexture,tt=[];for(let yt=0;yt<6;yt++)!ft&&!I?tt[yt]=v(b.image[yt],!0,s.maxCubemapSize):tt[yt]=I?b.image[yt].image:b.image[yt],tt[yt]=It(b,tt[yt]);let K=tt[0],pt=r.convert(b.format,b.colorSpace),ot=r.convert(b.type),ut=C(b.internalFormat,pt,ot,b.normalized,b.colorSpace),Ct=b.isVideoTexture!==!0,Ht=ht.__version===void 0||st===!0,rt=et.dataReady,Rt=T(b,K);se(i.TEXTURE_CUBE_MAP,b);let Vt;if(b.isDepthTexture){if(ut=y(b.format===ti,b.type),Ht)if(Ct)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,ut,K.width,K.height);else for(let yt=0;yt<6;yt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,ut,K.width,K.height,0,pt,ot,null)}else if(ft){Ct&&Ht&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Rt,ut,K.width,K.height);for(let yt=0;yt<6;yt++){Vt=tt[yt].mipmaps;for(let re=0;re<Vt.length;re++){let Ie=Vt[re];b.format!==Ln?pt!==null?Ct?rt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,re,0,0,Ie.width,Ie.height,pt,Ie.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,re,ut,Ie.width,Ie.height,0,Ie.data):Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ct?rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,re,0,0,Ie.width,Ie.height,pt,ot,Ie.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,re,ut,Ie.width,Ie.height,0,pt,ot,Ie.data)}}}else{if(Vt=b.mipmaps,Ct&&Ht){Vt.length>0&&Rt++;let yt=Bt(tt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Rt,ut,yt.width,yt.height)}for(let yt=0;yt<6;yt++)if(I){Ct?rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,0,0,tt[yt].width,tt[yt].height,pt,ot,tt[yt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,ut,tt[yt].width,tt[yt].height,0,pt,ot,tt[yt].data);for(let re=0;re<Vt.length;re++){let ii=Vt[re].image[yt].image;Ct?rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,re+1,0,0,ii.width,ii.height,pt,ot,ii.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,re+1,ut,ii.width,ii.height,0,pt,ot,ii.data)}}else{Ct?rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,0,0,pt,ot,tt[yt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,ut,pt,ot,tt[yt]);for(let re=0;re<Vt.length;re++){let Ie=Vt[re];Ct?rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,re+1,0,0,pt,ot,Ie.image[yt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+yt,re+1,ut,pt,ot,Ie.image[yt])}}}w(b)&&b.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),ht.__version=et.version,b.onUpdate&&b.onUpdate(b)}A.__version=b.version}function ye(A,b,V,st,et,ht){let gt=r.convert(V.format,V.colorSpace),j=r.convert(V.type),Q=C(V.internalFormat,gt,j,V.normalized,V.colorSpace),ft=n.get(b),I=n.get(V);if(I.__renderTarget=b,!ft.__hasExternalTextures){let tt=Math.max(1,b.width>>ht),K=Math.max(1,b.height>>ht);et===i.TEXTURE_3D||et===i.TEXTURE_2D_ARRAY?e.texImage3D(et,ht,Q,tt,K,b.depth,0,gt,j,null):e.texImage2D(et,ht,Q,tt,K,0,gt,j,null)}e.bindFramebuffer(i.FRAMEBUFFER,A),xt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,st,et,I.__webglTexture,0,ge(b)):(et===i.TEXTURE_2D||et>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&et<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,st,et,I.__webglTexture,ht),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Dn(A,b,V){if(i.bindRenderbuffer(i.RENDERBUFFER,A),b.depthBuffer){let st=b.depthTexture,et=st&&st.isDepthTexture?st.type:null,ht=y(b.stencilBuffer,et),gt=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;xt(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ge(b),ht,b.width,b.height):V?i.renderbufferStorageMultisample(i.RENDERBUFFER,ge(b),ht,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,ht,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,gt,i.RENDERBUFFER,A)}else{let st=b.textures;for(let et=0;et<st.length;et++){let ht=st[et],gt=r.convert(ht.format,ht.colorSpace),j=r.convert(ht.type),Q=C(ht.internalFormat,gt,j,ht.normalized,ht.colorSpace);xt(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ge(b),Q,b.width,b.height):V?i.renderbufferStorageMultisample(i.RENDERBUFFER,ge(b),Q,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,Q,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Pe(A,b,V){let st=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,A),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let et=n.get(b.depthTexture);et.__renderTarget=b;let ht=st?b.depthTexture.image[0]:b.depthTexture.image;(!et.__webglTexture||ht.width!==b.width||ht.height!==b.height)&&(ht.width=b.width,ht.height=b.height,b.depthTexture.needsUpdate=!0),st?lt(b.depthTexture,0):it(b.depthTexture,0);let gt=et.__webglTexture,j=ge(b),Q=st?i.TEXTURE_CUBE_MAP_POSITIVE_X+V:i.TEXTURE_2D,ft=b.depthTexture.format===ti?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===Zn)xt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ft,Q,gt,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,ft,Q,gt,0);else if(b.depthTexture.format===ti)xt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ft,Q,gt,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,ft,Q,gt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function mn(A){let b=n.get(A),V=A.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==A.depthTexture){let st=A.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),st){let et=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,st.removeEventListener("dispose",et)};st.addEventListener("dispose",et),b.__depthDisposeCallback=et}b.__boundDepthTexture=st}if(A.depthTexture&&!b.__autoAllocateDepthBuffer)if(V)for(let st=0;st<6;st++)Pe(b.__webglFramebuffer[st],A,st);else A.texture.mipmaps.length>0?Pe(b.__webglFramebuffer[0],A,0):Pe(b.__webglFramebuffer,A,0);else if(V){b.__webglDepthbuffer=[];for(let st=0;st<6;st++)if(e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[st]),b.__webglDepthbuffer[st]===void 0)b.__webglDepthbuffer[st]=i.createRenderbuffer(),Dn(b.__webglDepthbuffer[st],A,!1);else{let et=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ht=b.__webglDepthbuffer[st];i.bindRenderbuffer(i.RENDERBUFFER,ht),i.framebufferRenderbuffer(i.FRAMEBUFFER,et,i.RENDERBUFFER,ht)}}else if(A.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),Dn(b.__webglDepthbuffer,A,!1);else{let et=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ht=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ht),i.framebufferRenderbuffer(i.FRAMEBUFFER,et,i.RENDERBUFFER,ht)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function gn(A,b,V){let st=n.get(A);b!==void 0&&ye(st.__webglFramebuffer,A,A.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),V!==void 0&&mn(A)}function _n(A){let b=A.texture,V=n.get(A),st=n.get(b);A.addEventListener("dispose",B),U(A);let et=A.textures,ht=A.isWebGLCubeRenderTarget===!0,gt=et.length>1;if(gt||(st.__webglTexture===void 0&&(st.__webglTexture=i.createTexture()),st.__version=b.version,o.memory.textures++),ht){V.__webglFramebuffer=[];for(let j=0;j<6;j++)if(b.mipmaps.length>0){V.__webglFramebuffer[j]=[];for(let Q=0;Q<b.mipmaps.length;Q++)V.__webglFramebuffer[j][Q]=i.createFramebuffer()}else V.__webglFramebuffer[j]=i.createFramebuffer()}else{if(b.mipmaps.length>0){V.__webglFramebuffer=[];for(let j=0;j<b.mipmaps.length;j++)V.__webglFramebuffer[j]=i.createFramebuffer()}else V.__webglFramebuffer=i.createFramebuffer();if(gt)for(let j=0,Q=et.length;j<Q;j++){let ft=n.get(et[j]);ft.__webglTexture===void 0&&(ft.__webglTexture=i.createTexture(),o.memory.textures++)}if(A.samples>0&&xt(A)===!1){V.__webglMultisampledFramebuffer=i.createFramebuffer(),V.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,V.__webglMultisampledFramebuffer);for(let j=0;j<et.length;j++){let Q=et[j];V.__webglColorRenderbuffer[j]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,V.__webglColorRenderbuffer[j]);let ft=r.convert(Q.format,Q.colorSpace),I=r.convert(Q.type),tt=C(Q.internalFormat,ft,I,Q.normalized,Q.colorSpace,A.isXRRenderTarget===!0),K=ge(A);i.renderbufferStorageMultisample(i.RENDERBUFFER,K,tt,A.width,A.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+j,i.RENDERBUFFER,V.__webglColorRenderbuffer[j])}i.bindRenderbuffer(i.RENDERBUFFER,null),A.depthBuffer&&(V.__webglDepthRenderbuffer=i.createRenderbuffer(),Dn(V.__webglDepthRenderbuffer,A,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ht){e.bindTexture(i.TEXTURE_CUBE_MAP,st.__webglTexture),se(i.TEXTURE_CUBE_MAP,b);for(let j=0;j<6;j++)if(b.mipmaps.length>0)for(let Q=0;Q<b.mipmaps.length;Q++)ye(V.__webglFramebuffer[j][Q],A,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+j,Q);else ye(V.__webglFramebuffer[j],A,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+j,0);w(b)?M(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(gt){for(let j=0,Q=et.length;j<Q;j++){let ft=et[j],I=n.get(ft),tt=i.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(tt=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(tt,I.__webglTexture),se(tt,ft),ye(V.__webglFramebuffer,A,ft,i.COLOR_ATTACHMENT0+j,tt,0),w(ft)&&M(tt)}e.unbindTexture()}else{let j=i.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(j=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(j,st.__webglTexture),se(j,b),b.mipmaps.length>0)for(let Q=0;Q<b.mipmaps.length;Q++)ye(V.__webglFramebuffer[Q],A,b,i.COLOR_ATTACHMENT0,j,Q);else ye(V.__webglFramebuffer,A,b,i.COLOR_ATTACHMENT0,j,0);w(b)?M(j):b.mipmaps.length>0&&i.texParameteri(j,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}A.depthBuffer&&mn(A)}function F(A){let b=A.textures;for(let V=0,st=b.length;V<st;V++){let et=b[V];if(w(et)&&et.mipmapsAutoUpdate===!0){let ht=P(A),gt=n.get(et).__webglTexture;e.bindTexture(ht,gt),M(ht),e.unbindTexture()}}}let xn=[];function me(A){if(A.samples>0){if(xt(A)===!1){let b=A.textures,V=A.width,st=A.height,et=i.COLOR_BUFFER_BIT,ht=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,gt=n.get(A),j=b.length>1;if(j)for(let ft=0;ft<b.length;ft++)e.bindFramebuffer(i.FRAMEBUFFER,gt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ft,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,gt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ft,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,gt.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,gt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,gt.__webglFramebuffer);for(let ft=0;ft<b.length;ft++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(et|=i.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(et|=i.STENCIL_BUFFER_BIT)),j){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,gt.__webglColorRenderbuffer[ft]);let I=n.get(b[ft]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,I,0)}i.blitFramebuffer(0,0,V,st,0,0,V,st,et,i.NEAREST),l===!0&&(xn.length=0,xn.push(i.COLOR_ATTACHMENT0+ft),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&xn.push(ht),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,xn))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),j)for(let ft=0;ft<b.length;ft++){e.bindFramebuffer(i.FRAMEBUFFER,gt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ft,i.RENDERBUFFER,gt.__webglColorRenderbuffer[ft]);let I=n.get(b[ft]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,gt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ft,i.TEXTURE_2D,I,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,gt.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let b=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function ge(A){return Math.min(s.maxSamples,A.samples)}function xt(A){let b=n.get(A);return A.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Te(A){let b=o.render.frame;h.get(A)!==b&&(h.set(A,b),A.update())}function It(A,b){let V=A.colorSpace,st=A.format,et=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||V!==rr&&V!==ei&&(Kt.getTransfer(V)===ie?(st!==Ln||et!==en)&&Pt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Nt("WebGLTextures: Unsupported texture color space:",V)),b}function Bt(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=at,this.resetTextureUnits=k,this.getTextureUnits=Z,this.setTextureUnits=dt,this.setTexture2D=it,this.setTexture2DArray=ct,this.setTexture3D=St,this.setTextureCube=lt,this.rebindTextures=gn,this.setupRenderTarget=_n,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=me,this.setupDepthRenderbuffer=mn,this.setupFrameBufferTexture=ye,this.useMultisampledRTT=xt,this.dispose=Y}function $v(i,t){function e(n,s=ei){let r,o=Kt.getTransfer(s);if(n===en)return i.UNSIGNED_BYTE;if(n===Da)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Na)return i.UNSIGNED_SHORT_5_5_5_1;if(n===dh)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===fh)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===hh)return i.BYTE;if(n===uh)return i.SHORT;if(n===Ls)return i.UNSIGNED_SHORT;if(n===La)return i.INT;if(n===Rn)return i.UNSIGNED_INT;if(n===Pn)return i.FLOAT;if(n===In)return i.HALF_FLOAT;if(n===ph)return i.ALPHA;if(n===mh)return i.RGB;if(n===Ln)return i.RGBA;if(n===Zn)return i.DEPTH_COMPONENT;if(n===ti)return i.DEPTH_STENCIL;if(n===gh)return i.RED;if(n===Oa)return i.RED_INTEGER;if(n===Ti)return i.RG;if(n===Ua)return i.RG_INTEGER;if(n===Fa)return i.RGBA_INTEGER;if(n===Ir||n===Lr||n===Dr||n===Nr)if(o===ie)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ir)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Lr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Dr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Nr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ir)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Lr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Dr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Nr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===ka||n===Ba||n===za||n===Va)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===ka)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ba)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===za)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Va)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Ga||n===Ha||n===Wa||n===Xa||n===$a||n===Or||n===qa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Ga||n===Ha)return o===ie?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Wa)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Xa)return r.COMPRESSED_R11_EAC;if(n===$a)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Or)return r.COMPRESSED_RG11_EAC;if(n===qa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Ya||n===Za||n===Ka||n===Ja||n===ja||n===Qa||n===tl||n===el||n===nl||n===il||n===sl||n===rl||n===ol||n===al)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Ya)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Za)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ka)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Ja)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ja)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Qa)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===tl)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===el)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===nl)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===il)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===sl)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===rl)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ol)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===al)return o===ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ll||n===cl||n===hl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===ll)return o===ie?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===cl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===hl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===ul||n===dl||n===Ur||n===fl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===ul)return r.COMPRESSED_RED_RGTC1_EXT;if(n===dl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ur)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===fl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Gi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var qv=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Yv=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Bh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new pr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new kn({vertexShader:qv,fragmentShader:Yv,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new ze(new _r(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},zh=class extends Cn{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,f=null,u=null,d=null,g=null,x=typeof XRWebGLBinding<"u",m=new Bh,_={},v=e.getContextAttributes(),w=null,M=null,P=[],C=[],y=new Mt,T=null,U=null,L=new Ze;L.viewport=new _e;let O=new Ze;O.viewport=new _e;let B=[L,O],H=new Aa,D=null,Y=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(W){let it=P[W];return it===void 0&&(it=new bs,P[W]=it),it.getTargetRaySpace()},this.getControllerGrip=function(W){let it=P[W];return it===void 0&&(it=new bs,P[W]=it),it.getGripSpace()},this.getHand=function(W){let it=P[W];return it===void 0&&(it=new bs,P[W]=it),it.getHandSpace()};function J(W){let it=C.indexOf(W.inputSource);if(it===-1)return;let ct=P[it];ct!==void 0&&(ct.update(W.inputSource,W.frame,c||o),ct.dispatchEvent({type:W.type,data:W.inputSource}))}function X(){s.removeEventListener("select",J),s.removeEventListener("selectstart",J),s.removeEventListener("selectend",J),s.removeEventListener("squeeze",J),s.removeEventListener("squeezestart",J),s.removeEventListener("squeezeend",J),s.removeEventListener("end",X),s.removeEventListener("inputsourceschange",nt);for(let W=0;W<P.length;W++){let it=C[W];it!==null&&(C[W]=null,P[W].disconnect(it))}D=null,Y=null,m.reset();for(let W in _)delete _[W];if(t.setRenderTarget(w),d=null,u=null,f=null,s=null,M=null,at.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(y.width,y.height,!1),U!==null){let W=U.camera;W.fov=U.fov,W.zoom=U.zoom,W.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(W){r=W,n.isPresenting===!0&&Pt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(W){a=W,n.isPresenting===!0&&Pt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(W){c=W},this.getBaseLayer=function(){return u!==null?u:d},this.getBinding=function(){return f===null&&x&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(W){if(s=W,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",J),s.addEventListener("selectstart",J),s.addEventListener("selectend",J),s.addEventListener("squeeze",J),s.addEventListener("squeezestart",J),s.addEventListener("squeezeend",J),s.addEventListener("end",X),s.addEventListener("inputsourceschange",nt),v.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let ct=null,St=null,lt=null;v.depth&&(lt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,ct=v.stencil?ti:Zn,St=v.stencil?Gi:Rn);let Lt={colorFormat:e.RGBA8,depthFormat:lt,scaleFactor:r};f=this.getBinding(),u=f.createProjectionLayer(Lt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),M=new dn(u.textureWidth,u.textureHeight,{format:Ln,type:en,depthTexture:new jn(u.textureWidth,u.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,ct),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let ct={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,ct),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new dn(d.framebufferWidth,d.framebufferHeight,{format:Ln,type:en,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),at.setContext(s),at.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function nt(W){for(let it=0;it<W.removed.length;it++){let ct=W.removed[it],St=C.indexOf(ct);St>=0&&(C[St]=null,P[St].disconnect(ct))}for(let it=0;it<W.added.length;it++){let ct=W.added[it],St=C.indexOf(ct);if(St===-1){for(let Lt=0;Lt<P.length;Lt++)if(Lt>=C.length){C.push(ct),St=Lt;break}else if(C[Lt]===null){C[Lt]=ct,St=Lt;break}if(St===-1)break}let lt=P[St];lt&&lt.connect(ct)}}function q(W,it){it===null?W.matrixWorld.copy(W.matrix):W.matrixWorld.multiplyMatrices(it.matrixWorld,W.matrix),W.matrixWorldInverse.copy(W.matrixWorld).invert()}this.updateCamera=function(W){if(s===null)return;let it=W.near,ct=W.far;m.texture!==null&&(m.depthNear>0&&(it=m.depthNear),m.depthFar>0&&(ct=m.depthFar)),H.near=O.near=L.near=it,H.far=O.far=L.far=ct,(D!==H.near||Y!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),D=H.near,Y=H.far),H.layers.mask=W.layers.mask|6,L.layers.mask=H.layers.mask&-5,O.layers.mask=H.layers.mask&-3;let St=W.parent,lt=H.cameras;q(H,St);for(let Lt=0;Lt<lt.length;Lt++)q(lt[Lt],St);H.projectionMatrix.copy(L.projectionMatrix),H.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&W.isPerspectiveCamera&&(U={camera:W,fov:W.fov,zoom:W.zoom}),k(W,H,St)};function k(W,it,ct){ct===null?W.matrix.copy(it.matrixWorld):(W.matrix.copy(ct.matrixWorld),W.matrix.invert(),W.matrix.multiply(it.matrixWorld)),W.matrix.decompose(W.position,W.quaternion,W.scale),W.updateMatrixWorld(!0),W.projectionMatrix.copy(it.projectionMatrix),W.projectionMatrixInverse.copy(it.projectionMatrixInverse),W.isPerspectiveCamera&&(W.fov=xs*2*Math.atan(1/W.projectionMatrix.elements[5]),W.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(u===null&&d===null))return l},this.setFoveation=function(W){l=W,u!==null&&(u.fixedFoveation=W),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=W)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(H)},this.getCameraTexture=function(W){return _[W]};let Z=null;function dt(W,it){if(h=it.getViewerPose(c||o),g=it,h!==null){let ct=h.views;d!==null&&(t.setRenderTargetFramebuffer(M,d.framebuffer),t.setRenderTarget(M));let St=!1;ct.length!==H.cameras.length&&(H.cameras.length=0,St=!0);for(let Dt=0;Dt<ct.length;Dt++){let se=ct[Dt],ce=null;if(d!==null)ce=d.getViewport(se);else{let Fe=f.getViewSubImage(u,se);ce=Fe.viewport,Dt===0&&(t.setRenderTargetTextures(M,Fe.colorTexture,Fe.depthStencilTexture),t.setRenderTarget(M))}let $t=B[Dt];$t===void 0&&($t=new Ze,$t.layers.enable(Dt),$t.viewport=new _e,B[Dt]=$t),$t.matrix.fromArray(se.transform.matrix),$t.matrix.decompose($t.position,$t.quaternion,$t.scale),$t.projectionMatrix.fromArray(se.projectionMatrix),$t.projectionMatrixInverse.copy($t.projectionMatrix).invert(),$t.viewport.set(ce.x,ce.y,ce.width,ce.height),Dt===0&&(H.matrix.copy($t.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),St===!0&&H.cameras.push($t)}let lt=s.enabledFeatures;if(lt&&lt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){f=n.getBinding();let Dt=f.getDepthInformation(ct[0]);Dt&&Dt.isValid&&Dt.texture&&m.init(Dt,s.renderState)}if(lt&&lt.includes("camera-access")&&x){t.state.unbindTexture(),f=n.getBinding();for(let Dt=0;Dt<ct.length;Dt++){let se=ct[Dt].camera;if(se){let ce=_[se];ce||(ce=new pr,_[se]=ce);let $t=f.getCameraImage(se);ce.sourceTexture=$t}}}}for(let ct=0;ct<P.length;ct++){let St=C[ct],lt=P[ct];St!==null&&lt!==void 0&&lt.update(St,it,c||o)}Z&&Z(W,it),it.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:it}),g=null}let at=new cp;at.setAnimationLoop(dt),this.setAnimationLoop=function(W){Z=W},this.dispose=function(){}}},Zv=new Qt,yp=new Ft;yp.set(-1,0,0,0,1,0,0,0,1);function Kv(i,t){function e(m,_){m.matrixAutoUpdate===!0&&m.updateMatrix(),_.value.copy(m.matrix)}function n(m,_){_.color.getRGB(m.fogColor.value,Ah(i)),_.isFog?(m.fogNear.value=_.near,m.fogFar.value=_.far):_.isFogExp2&&(m.fogDensity.value=_.density)}function s(m,_,v,w,M){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?r(m,_):_.isMeshLambertMaterial?(r(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(r(m,_),f(m,_)):_.isMeshPhongMaterial?(r(m,_),h(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(r(m,_),u(m,_),_.isMeshPhysicalMaterial&&d(m,_,M)):_.isMeshMatcapMaterial?(r(m,_),g(m,_)):_.isMeshDepthMaterial?r(m,_):_.isMeshDistanceMaterial?(r(m,_),x(m,_)):_.isMeshNormalMaterial?r(m,_):_.isLineBasicMaterial?(o(m,_),_.isLineDashedMaterial&&a(m,_)):_.isPointsMaterial?l(m,_,v,w):_.isSpriteMaterial?c(m,_):_.isShadowMaterial?(m.color.value.copy(_.color),m.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function r(m,_){m.opacity.value=_.opacity,_.color&&m.diffuse.value.copy(_.color),_.emissive&&m.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(m.map.value=_.map,e(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,e(_.alphaMap,m.alphaMapTransform)),_.bumpMap&&(m.bumpMap.value=_.bumpMap,e(_.bumpMap,m.bumpMapTransform),m.bumpScale.value=_.bumpScale,_.side===Je&&(m.bumpScale.value*=-1)),_.normalMap&&(m.normalMap.value=_.normalMap,e(_.normalMap,m.normalMapTransform),m.normalScale.value.copy(_.normalScale),_.side===Je&&m.normalScale.value.negate()),_.displacementMap&&(m.displacementMap.value=_.displacementMap,e(_.displacementMap,m.displacementMapTransform),m.displacementScale.value=_.displacementScale,m.displacementBias.value=_.displacementBias),_.emissiveMap&&(m.emissiveMap.value=_.emissiveMap,e(_.emissiveMap,m.emissiveMapTransform)),_.specularMap&&(m.specularMap.value=_.specularMap,e(_.specularMap,m.specularMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest);let v=t.get(_),w=v.envMap,M=v.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(Zv.makeRotationFromEuler(M)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(yp),m.reflectivity.value=_.reflectivity,m.ior.value=_.ior,m.refractionRatio.value=_.refractionRatio),_.lightMap&&(m.lightMap.value=_.lightMap,m.lightMapIntensity.value=_.lightMapIntensity,e(_.lightMap,m.lightMapTransform)),_.aoMap&&(m.aoMap.value=_.aoMap,m.aoMapIntensity.value=_.aoMapIntensity,e(_.aoMap,m.aoMapTransform))}function o(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,_.map&&(m.map.value=_.map,e(_.map,m.mapTransform))}function a(m,_){m.dashSize.value=_.dashSize,m.totalSize.value=_.dashSize+_.gapSize,m.scale.value=_.scale}function l(m,_,v,w){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.size.value=_.size*v,m.scale.value=w*.5,_.map&&(m.map.value=_.map,e(_.map,m.uvTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,e(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function c(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.rotation.value=_.rotation,_.map&&(m.map.value=_.map,e(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,e(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function h(m,_){m.specular.value.copy(_.specular),m.shininess.value=Math.max(_.shininess,1e-4)}function f(m,_){_.gradientMap&&(m.gradientMap.value=_.gradientMap)}function u(m,_){m.metalness.value=_.metalness,_.metalnessMap&&(m.metalnessMap.value=_.metalnessMap,e(_.metalnessMap,m.metalnessMapTransform)),m.roughness.value=_.roughness,_.roughnessMap&&(m.roughnessMap.value=_.roughnessMap,e(_.roughnessMap,m.roughnessMapTransform)),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)}function d(m,_,v){m.ior.value=_.ior,_.diffuseRoughness>0&&(m.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=_.diffuseRoughnessMap,e(_.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),_.sheen>0&&(m.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),m.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(m.sheenColorMap.value=_.sheenColorMap,e(_.sheenColorMap,m.sheenColorMapTransform)),_.sheenRoughnessMap&&(m.sheenRoughnessMap.value=_.sheenRoughnessMap,e(_.sheenRoughnessMap,m.sheenRoughnessMapTransform))),_.clearcoat>0&&(m.clearcoat.value=_.clearcoat,m.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(m.clearcoatMap.value=_.clearcoatMap,e(_.clearcoatMap,m.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,e(_.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(m.clearcoatNormalMap.value=_.clearcoatNormalMap,e(_.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===Je&&m.clearcoatNormalScale.value.negate())),_.dispersion>0&&(m.dispersion.value=_.dispersion),_.retroreflectivity>0&&(m.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(m.iridescence.value=_.iridescence,m.iridescenceIOR.value=_.iridescenceIOR,m.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(m.iridescenceMap.value=_.iridescenceMap,e(_.iridescenceMap,m.iridescenceMapTransform)),_.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=_.iridescenceThicknessMap,e(_.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),_.transmission>0&&(m.transmission.value=_.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),_.transmissionMap&&(m.transmissionMap.value=_.transmissionMap,e(_.transmissionMap,m.transmissionMapTransform)),m.thickness.value=_.thickness,_.thicknessMap&&(m.thicknessMap.value=_.thicknessMap,e(_.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=_.attenuationDistance,m.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(m.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(m.anisotropyMap.value=_.anisotropyMap,e(_.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=_.specularIntensity,m.specularColor.value.copy(_.specularColor),_.specularColorMap&&(m.specularColorMap.value=_.specularColorMap,e(_.specularColorMap,m.specularColorMapTransform)),_.specularIntensityMap&&(m.specularIntensityMap.value=_.specularIntensityMap,e(_.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,_){_.matcap&&(m.matcap.value=_.matcap)}function x(m,_){let v=t.get(_).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Jv(i,t,e,n){let s={},r={};function o(v,w){let M=w.program;n.uniformBlockBinding(v,M,s[v.id])}function a(v,w){let M=s[v.id];M===void 0&&(g(v),M=l(v),s[v.id]=M,v.addEventListener("dispose",m));let P=w.program;n.updateUBOMapping(v,P);let C=t.render.frame;r[v.id]!==C&&(c(v),r[v.id]=C)}function l(v){let w=i.createBuffer(),M=v.__size,P=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,w),i.bufferData(i.UNIFORM_BUFFER,M,P),i.bindBuffer(i.UNIFORM_BUFFER,null),w}function c(v){let w=s[v.id],M=v.uniforms,P=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,w);for(let C=0,y=M.length;C<y;C++){let T=M[C];if(Array.isArray(T))for(let U=0,L=T.length;U<L;U++)h(T[U],C,U,P);else h(T,C,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,w,M,P){if(u(v,w,M,P)===!0){let C=v.__offset,y=v.value;if(Array.isArray(y)){let T=0;for(let U=0;U<y.length;U++){let L=y[U],O=x(L,!0);f(L,v.__data,T),T+=O.storage/Float32Array.BYTES_PER_ELEMENT}}else f(y,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,C,v.__data)}}function f(v,w,M){typeof v=="number"||typeof v=="boolean"?w[M]=v:v.isMatrix3?(w[M]=v.elements[0],w[M+1]=v.elements[1],w[M+2]=v.elements[2],w[M+3]=0,w[M+4]=v.elements[3],w[M+5]=v.elements[4],w[M+6]=v.elements[5],w[M+7]=0,w[M+8]=v.elements[6],w[M+9]=v.elements[7],w[M+10]=v.elements[8],w[M+11]=0):ArrayBuffer.isView(v)?w.set(v.subarray(0,w.length-M),M):v.toArray(w,M)}function u(v,w,M,P){let C=v.value,y=w+"_"+M;if(Array.isArray(C)){P[y]===void 0&&(P[y]=[]);let T=P[y],U=!1;for(let L=0;L<C.length;L++)d(C[L],T,L)===!0&&(U=!0);return U}return d(C,P,y)}function d(v,w,M){if(w[M]===void 0)return typeof v=="number"||typeof v=="boolean"?w[M]=v:ArrayBuffer.isView(v)?w[M]=v.slice():w[M]=v.clone(),!0;{let P=w[M];if(typeof v=="number"||typeof v=="boolean"){if(P!==v)return w[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(P.equals(v)===!1)return P.copy(v),!0}}return!1}function g(v){let w=v.uniforms,M=0,P=16;for(let y=0,T=w.length;y<T;y++){let U=Array.isArray(w[y])?w[y]:[w[y]];for(let L=0,O=U.length;L<O;L++){let B=U[L],H=Array.isArray(B.value)?B.value:[B.value],D=Array.isArray(w[y])||Array.isArray(B.value),Y=M;for(let X=0,nt=H.length;X<nt;X++){let q=H[X],k=x(q,D),Z=M%P,dt=Z%k.boundary,at=Z+dt;M+=dt,at!==0&&P-at<k.storage&&(M+=P-at),X===0&&(Y=M),M+=k.storage}let J=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new J((M-Y)/Float32Array.BYTES_PER_ELEMENT),B.__offset=Y}}let C=M%P;return C>0&&(M+=P-C),v.__size=M,v.__cache={},this}function x(v,w){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?Pt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):Pt("WebGLRenderer: Unsupported uniform value type.",v),w===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(v){let w=v.target;w.removeEventListener("dispose",m),i.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function _(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:_}}var jv=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),zn=null;function Qv(){return zn===null&&(zn=new ea(jv,16,16,Ti,In),zn.name="DFG_LUT",zn.minFilter=Ke,zn.magFilter=Ke,zn.wrapS=Un,zn.wrapT=Un,zn.generateMipmaps=!1,zn.needsUpdate=!0),zn}var xl=class{constructor(t={}){let{canvas:e=Lf(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:u=!1,outputBufferType:d=en}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let x=d,m=new Set([Fa,Ua,Oa]),_=new Set([en,Rn,Ls,Gi,Da,Na]),v=new Uint32Array(4),w=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},P=null,C=null,y=[],T=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Bn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,O=!1,B=null,H=null,D=null,Y=null;this._outputColorSpace=cn;let J=0,X=0,nt=null,q=-1,k=null,Z=new _e,dt=new _e,at=null,W=new kt(0),it=0,ct=e.width,St=e.height,lt=1,Lt=null,xe=null,Dt=new _e(0,0,ct,St),se=new _e(0,0,ct,St),ce=!1,$t=new gi,Fe=new na,we=!1,je=!1,ye=new Qt,Dn=new R,Pe=new _e,mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},gn=!1;function _n(){return nt===null?lt:1}let F=n;function xn(S,N){return e.getContext(S,N)}let me,ge,xt,Te,It,Bt,A,b,V,st,et,ht,gt,j,Q,ft,I,tt,K,pt,ot,ut,Ct;try{let S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Rt,!1),e.addEventListener("webglcontextrestored",Vt,!1),e.addEventListener("webglcontextcreationerror",yt,!1),F===null){let N="webgl2";if(F=xn(N,S),F===null)throw xn(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ht()}catch(S){throw e.removeEventListener("webglcontextlost",Rt,!1),e.removeEventListener("webglcontextrestored",Vt,!1),e.removeEventListener("webglcontextcreationerror",yt,!1),Nt("WebGLRenderer: "+S.message),S}function Ht(){me=new hy(F),me.init(),ot=new $v(F,me),ge=new Qx(F,me,t,ot),xt=new Wv(F,me),ge.reversedDepthBuffer&&u&&xt.buffers.depth.setReversed(!0),H=F.createFramebuffer(),D=F.createFramebuffer(),Y=F.createFramebuffer(),Te=new fy(F),It=new Pv,Bt=new Xv(F,me,xt,It,ge,ot,Te),A=new cy(L),b=new m_(F),ut=new Jx(F,b),V=new uy(F,b,Te,ut),st=new my(F,V,b,ut,Te),tt=new py(F,ge,Bt),Q=new ty(It),et=new Rv(L,A,me,ge,ut,Q),ht=new Kv(L,It),gt=new Lv,j=new kv(me),I=new Kx(L,A,xt,st,g,l),ft=new Hv(L,st,ge),Ct=new Jv(F,Te,ge,xt),K=new jx(F,me,Te),pt=new dy(F,me,Te),Te.programs=et.programs,L.capabilities=ge,L.extensions=me,L.properties=It,L.renderLists=gt,L.shadowMap=ft,L.state=xt,L.info=Te}x!==en&&(U=new _y(x,e.width,e.height,a,s,r));let rt=new zh(L,F);this.xr=rt,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let S=me.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=me.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return lt},this.setPixelRatio=function(S){S!==void 0&&(lt=S,this.setSize(ct,St,!1))},this.getSize=function(S){return S.set(ct,St)},this.setSize=function(S,N,$=!0){if(rt.isPresenting){Pt("WebGLRenderer: Can't change size while VR device is presenting.");return}ct=S,St=N,e.width=Math.floor(S*lt),e.height=Math.floor(N*lt),$===!0&&(e.style.width=S+"px",e.style.height=N+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,S,N)},this.getDrawingBufferSize=function(S){return S.set(ct*lt,St*lt).floor()},this.setDrawingBufferSize=function(S,N,$){ct=S,St=N,lt=$,e.width=Math.floor(S*$),e.height=Math.floor(N*$),this.setViewport(0,0,S,N)},this.setEffects=function(S){if(x===en){Nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let N=0;N<S.length;N++)if(S[N].isOutputPass===!0){Pt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(Z)},this.getViewport=function(S){return S.copy(Dt)},this.setViewport=function(S,N,$,z){S.isVector4?Dt.set(S.x,S.y,S.z,S.w):Dt.set(S,N,$,z),xt.viewport(Z.copy(Dt).multiplyScalar(_n()).round())},this.getScissor=function(S){return S.copy(se)},this.setScissor=function(S,N,$,z){S.isVector4?se.set(S.x,S.y,S.z,S.w):se.set(S,N,$,z),xt.scissor(dt.copy(se).multiplyScalar(_n()).round())},this.getScissorTest=function(){return ce},this.setScissorTest=function(S){xt.setScissorTest(ce=S)},this.setOpaqueSort=function(S){Lt=S},this.setTransparentSort=function(S){xe=S},this.getClearColor=function(S){return S.copy(I.getClearColor())},this.setClearColor=function(){I.setClearColor(...arguments)},this.getClearAlpha=function(){return I.getClearAlpha()},this.setClearAlpha=function(){I.setClearAlpha(...arguments)},this.clear=function(S=!0,N=!0,$=!0){let z=0;if(S){let G=!1;if(nt!==null){let _t=nt.texture.format;G=m.has(_t)}if(G){let _t=nt.texture.type,wt=_.has(_t),mt=I.getClearColor(),bt=I.getClearAlpha(),At=mt.r,zt=mt.g,qt=mt.b;wt?(v[0]=At,v[1]=zt,v[2]=qt,v[3]=bt,F.clearBufferuiv(F.COLOR,0,v)):(w[0]=At,w[1]=zt,w[2]=qt,w[3]=bt,F.clearBufferiv(F.COLOR,0,w))}else z|=F.COLOR_BUFFER_BIT}N&&(z|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),$&&(z|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),z!==0&&F.clear(z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),B=S},this.dispose=function(){e.removeEventListener("webglcontextlost",Rt,!1),e.removeEventListener("webglcontextrestored",Vt,!1),e.removeEventListener("webglcontextcreationerror",yt,!1),I.dispose(),gt.dispose(),j.dispose(),Bt.dispose(),It.dispose(),A.dispose(),st.dispose(),V.dispose(),ut.dispose(),Ct.dispose(),et.dispose(),rt.dispose(),rt.removeEventListener("sessionstart",su),rt.removeEventListener("sessionend",ru),Ai.stop()};function Rt(S){S.preventDefault(),bh("WebGLRenderer: Context Lost."),O=!0}function Vt(){bh("WebGLRenderer: Context Restored."),O=!1;let S=Te.autoReset,N=ft.enabled,$=ft.autoUpdate,z=ft.needsUpdate,G=ft.type;Ht(),Te.autoReset=S,ft.enabled=N,ft.autoUpdate=$,ft.needsUpdate=z,ft.type=G}function yt(S){Nt("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function re(S){let N=S.target;N.removeEventListener("dispose",re),Ie(N)}function Ie(S){ii(S),It.remove(S)}function ii(S){let N=It.get(S).programs;N!==void 0&&(N.forEach(function($){et.releaseProgram($)}),S.isShaderMaterial&&et.releaseShaderCache(S))}this.renderBufferDirect=function(S,N,$,z,G,_t){N===null&&(N=mn);let wt=G.isMesh&&G.matrixWorld.determinantAffine()<0,mt=Am(S,N,$,z,G);xt.setMaterial(z,wt);let bt=$.index,At=1;if(z.wireframe===!0){if(bt=V.getWireframeAttribute($),bt===void 0)return;At=2}let zt=$.drawRange,qt=$.attributes.position,Tt=zt.start*At,Yt=(zt.start+zt.count)*At;_t!==null&&(Tt=Math.max(Tt,_t.start*At),Yt=Math.min(Yt,(_t.start+_t.count)*At)),bt!==null?(Tt=Math.max(Tt,0),Yt=Math.min(Yt,bt.count)):qt!=null&&(Tt=Math.max(Tt,0),Yt=Math.min(Yt,qt.count));let be=Yt-Tt;if(be<0||be===1/0)return;ut.setup(G,z,mt,$,bt);let de,he=K;if(bt!==null&&(de=b.get(bt),he=pt,he.setIndex(de)),G.isMesh)z.wireframe===!0?(xt.setLineWidth(z.wireframeLinewidth*_n()),he.setMode(F.LINES)):he.setMode(F.TRIANGLES);else if(G.isLine){let Ge=z.linewidth;Ge===void 0&&(Ge=1),xt.setLineWidth(Ge*_n()),G.isLineSegments?he.setMode(F.LINES):G.isLineLoop?he.setMode(F.LINE_LOOP):he.setMode(F.LINE_STRIP)}else G.isPoints?he.setMode(F.POINTS):G.isSprite&&he.setMode(F.TRIANGLES);if(G.isBatchedMesh)if(me.get("WEBGL_multi_draw"))he.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let Ge=G._multiDrawStarts,Et=G._multiDrawCounts,Ye=G._multiDrawCount,ee=bt?b.get(bt).bytesPerElement:1,Ci=It.get(z).currentProgram.getUniforms();for(let He=0;He<Ye;He++)Ci.setValue(F,"_gl_DrawID",He),he.render(Ge[He]/ee,Et[He])}else if(G.isInstancedMesh)he.renderInstances(Tt,be,G.count);else if($.isInstancedBufferGeometry){let Ge=$._maxInstanceCount!==void 0?$._maxInstanceCount:1/0,Et=Math.min($.instanceCount,Ge);he.renderInstances(Tt,be,Et)}else he.render(Tt,be)};function iu(S,N,$,z){B!==null&&S.isNodeMaterial&&B.setObject(z,S),we===!0&&Q.setState(S,$,!1),S.transparent===!0&&S.side===pn&&S.forceSinglePass===!1?(S.side=Je,S.needsUpdate=!0,Bs(S,N,z),S.side=wi,S.needsUpdate=!0,Bs(S,N,z),S.side=pn):Bs(S,N,z)}this.compile=function(S,N,$=null){$===null&&($=S),B!==null&&B.renderStart(S,N,$),C=j.get($),C.init(N),T.push(C),$.traverseVisible(function(G){G.isLight&&G.layers.test(N.layers)&&(C.pushLight(G),G.castShadow&&C.pushShadow(G))}),S!==$&&S.traverseVisible(function(G){G.isLight&&G.layers.test(N.layers)&&(C.pushLight(G),G.castShadow&&C.pushShadow(G))}),C.setupLights(),B!==null&&B.updateLights(C.state.lightsArray),je=this.localClippingEnabled,we=Q.init(this.clippingPlanes,je),we===!0&&Q.setGlobalState(this.clippingPlanes,N),B!==null&&ft.render(C.state.shadowsArray,$,N);let z=new Set;return S.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;let _t=G.material;if(_t)if(Array.isArray(_t))for(let wt=0;wt<_t.length;wt++){let mt=_t[wt];iu(mt,$,N,G),z.add(mt)}else iu(_t,$,N,G),z.add(_t)}),C=T.pop(),B!==null&&B.renderEnd(),z},this.compileAsync=function(S,N,$=null){let z=this.compile(S,N,$);return new Promise(G=>{function _t(){if(z.forEach(function(wt){let bt=It.get(wt).currentProgram;(bt===void 0||bt.isReady())&&z.delete(wt)}),z.size===0){G(S);return}setTimeout(_t,10)}me.get("KHR_parallel_shader_compile")!==null?_t():setTimeout(_t,10)})};let Dl=null;function Tm(S){Dl&&Dl(S)}function su(){Ai.stop()}function ru(){Ai.start()}let Ai=new cp;Ai.setAnimationLoop(Tm),typeof self<"u"&&Ai.setContext(self),this.setAnimationLoop=function(S){Dl=S,rt.setAnimationLoop(S),S===null?Ai.stop():Ai.start()},rt.addEventListener("sessionstart",su),rt.addEventListener("sessionend",ru),this.render=function(S,N){if(N!==void 0&&N.isCamera!==!0){Nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(O===!0)return;B!==null&&B.renderStart(S,N);let $=rt.enabled===!0&&rt.isPresenting===!0,z=U!==null&&(nt===null||$)&&U.begin(L,nt);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),rt.enabled===!0&&rt.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(rt.cameraAutoUpdate===!0&&rt.updateCamera(N),N=rt.getCamera()),S.isScene===!0&&S.onBeforeRender(L,S,N,nt),C=j.get(S,T.length),C.init(N),C.state.textureUnits=Bt.getTextureUnits(),T.push(C),ye.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?Fe.setFromArrayCamera(N):$t.setFromProjectionMatrix(ye,bn,N.reversedDepth),je=this.localClippingEnabled,we=Q.init(this.clippingPlanes,je),P=gt.get(S,y.length),P.init(),y.push(P),this.info.render.frame++,rt.enabled===!0&&rt.isPresenting===!0){let wt=L.xr.getDepthSensingMesh();wt!==null&&Nl(wt,N,-1/0,L.sortObjects)}Nl(S,N,0,L.sortObjects),P.finish(),B!==null&&B.updateLights(C.state.lightsArray),L.sortObjects===!0&&P.sort(Lt,xe),gn=rt.enabled===!1||rt.isPresenting===!1||rt.hasDepthSensing()===!1,gn&&I.addToRenderList(P,S),this.info.autoReset===!0&&this.info.reset(),we===!0&&Q.beginShadows();let G=C.state.shadowsArray;if(ft.render(G,S,N),we===!0&&Q.endShadows(),(z&&U.hasRenderPass())===!1){let wt=P.opaque,mt=P.transmissive;if(C.setupLights(),N.isArrayCamera){let bt=N.cameras;if(mt.length>0)for(let At=0,zt=bt.length;At<zt;At++){let qt=bt[At];au(wt,mt,S,qt)}gn&&I.render(S);for(let At=0,zt=bt.length;At<zt;At++){let qt=bt[At];ou(P,S,qt,qt.viewport)}}else mt.length>0&&au(wt,mt,S,N),gn&&I.render(S),ou(P,S,N)}nt!==null&&X===0&&(Bt.updateMultisampleRenderTarget(nt),Bt.updateRenderTargetMipmap(nt)),z&&U.end(L),S.isScene===!0&&S.onAfterRender(L,S,N),ut.resetDefaultState(),q=-1,k=null,T.pop(),T.length>0?(C=T[T.length-1],Bt.setTextureUnits(C.state.textureUnits),we===!0&&Q.setGlobalState(L.clippingPlanes,C.state.camera)):C=null,y.pop(),y.length>0?P=y[y.length-1]:P=null,B!==null&&B.renderEnd()};function Nl(S,N,$,z){if(S.visible===!1)return;if(S.layers.test(N.layers)){if(S.isGroup)$=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(N);else if(S.isLight)C.pushLight(S),S.castShadow&&C.pushShadow(S);else if(S.isSprite){let wt=N.isArrayCamera?Fe:$t;if(!S.frustumCulled||S.intersectsFrustum(wt)){z&&Pe.setFromMatrixPosition(S.matrixWorld).applyMatrix4(ye);let mt=st.update(S),bt=S.material;bt.visible&&P.push(S,mt,bt,$,Pe.z,null,N)}}else if(S.isMesh||S.isLine||S.isPoints){let wt=N.isArrayCamera?Fe:$t;if(!S.frustumCulled||S.intersectsFrustum(wt)){let mt=st.update(S),bt=S.material;if(z&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Pe.copy(S.boundingSphere.center)):(mt.boundingSphere===null&&mt.computeBoundingSphere(),Pe.copy(mt.boundingSphere.center)),Pe.applyMatrix4(S.matrixWorld).applyMatrix4(ye)),Array.isArray(bt)){let At=mt.groups;for(let zt=0,qt=At.length;zt<qt;zt++){let Tt=At[zt],Yt=bt[Tt.materialIndex];Yt&&Yt.visible&&P.push(S,mt,Yt,$,Pe.z,Tt,N)}}else bt.visible&&P.push(S,mt,bt,$,Pe.z,null,N)}}}let _t=S.children;for(let wt=0,mt=_t.length;wt<mt;wt++)Nl(_t[wt],N,$,z)}function ou(S,N,$,z){let{opaque:G,transmissive:_t,transparent:wt}=S;C.setupLightsView($),we===!0&&Q.setGlobalState(L.clippingPlanes,$),z&&xt.viewport(Z.copy(z)),G.length>0&&Zr(G,N,$),_t.length>0&&Zr(_t,N,$),wt.length>0&&Zr(wt,N,$),xt.buffers.depth.setTest(!0),xt.buffers.depth.setMask(!0),xt.buffers.color.setMask(!0),xt.setPolygonOffset(!1)}function au(S,N,$,z){if(($.isScene===!0?$.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[z.id]===void 0){let Tt=me.has("EXT_color_buffer_half_float")||me.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[z.id]=new dn(1,1,{generateMipmaps:!0,type:Tt?In:en,minFilter:Qn,samples:Math.max(4,ge.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Kt.workingColorSpace})}let _t=C.state.transmissionRenderTarget[z.id],wt=z.viewport||Z;_t.setSize(wt.z*L.transmissionResolutionScale,wt.w*L.transmissionResolutionScale);let mt=L.getRenderTarget(),bt=L.getActiveCubeFace(),At=L.getActiveMipmapLevel();L.setRenderTarget(_t),L.getClearColor(W),it=L.getClearAlpha(),it<1&&L.setClearColor(16777215,.5),L.clear(),gn&&I.render($);let zt=L.toneMapping;L.toneMapping=Bn;let qt=z.viewport;if(z.viewport!==void 0&&(z.viewport=void 0),C.setupLightsView(z),we===!0&&Q.setGlobalState(L.clippingPlanes,z),Zr(S,$,z),Bt.updateMultisampleRenderTarget(_t),Bt.updateRenderTargetMipmap(_t),me.has("WEBGL_multisampled_render_to_texture")===!1){let Tt=!1;for(let Yt=0,be=N.length;Yt<be;Yt++){let de=N[Yt],{object:he,geometry:Ge,material:Et,group:Ye}=de;if(Et.side===pn&&he.layers.test(z.layers)){let ee=Et.side;Et.side=Je,Et.needsUpdate=!0,lu(he,$,z,Ge,Et,Ye),Et.side=ee,Et.needsUpdate=!0,Tt=!0}}Tt===!0&&(Bt.updateMultisampleRenderTarget(_t),Bt.updateRenderTargetMipmap(_t))}L.setRenderTarget(mt,bt,At),L.setClearColor(W,it),qt!==void 0&&(z.viewport=qt),L.toneMapping=zt}function Zr(S,N,$){let z=N.isScene===!0?N.overrideMaterial:null;for(let G=0,_t=S.length;G<_t;G++){let wt=S[G],{object:mt,geometry:bt,group:At}=wt,zt=wt.material;zt.allowOverride===!0&&z!==null&&(zt=z),mt.layers.test($.layers)&&lu(mt,N,$,bt,zt,At)}}function lu(S,N,$,z,G,_t){B!==null&&G.isNodeMaterial&&B.setObject(S,G),S.onBeforeRender(L,N,$,z,G,_t),S.modelViewMatrix.multiplyMatrices($.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),G.onBeforeRender(L,N,$,z,S,_t),G.transparent===!0&&G.side===pn&&G.forceSinglePass===!1?(G.side=Je,G.needsUpdate=!0,L.renderBufferDirect($,N,z,G,S,_t),G.side=wi,G.needsUpdate=!0,L.renderBufferDirect($,N,z,G,S,_t),G.side=pn):L.renderBufferDirect($,N,z,G,S,_t),S.onAfterRender(L,N,$,z,G,_t)}function cu(S){let N=0;for(let $ of S)$.texture!==null&&N++;return N}function Bs(S,N,$){N.isScene!==!0&&(N=mn);let z=It.get(S),G=C.state.lights,_t=C.state.shadowsArray,wt=G.state.version,mt=et.getParameters(S,G.state,_t,N,$,C.state.lightProbeGridArray),bt=et.getProgramCacheKey(mt),At=z.programs;z.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?N.environment:null,z.fog=N.fog;let zt=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;z.envMap=A.get(S.envMap||z.environment,zt),z.envMapRotation=z.environment!==null&&S.envMap===null?N.environmentRotation:S.envMapRotation,At===void 0&&(S.addEventListener("dispose",re),At=new Map,z.programs=At,z.programVariants=new Map);let qt=At.get(bt);if(qt!==void 0){if(z.currentProgram===qt&&z.lightsStateVersion===wt)return uu(S,mt),qt}else mt.uniforms=et.getUniforms(S),B!==null&&S.isNodeMaterial&&B.build(S,$,mt),S.onBeforeCompile(mt,L),qt=et.acquireProgram(mt,bt),At.set(bt,qt),z.uniforms=mt.uniforms;let Tt=z.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(Tt.clippingPlanes=Q.uniform),uu(S,mt),z.needsLights=Rm(S),z.lightsStateVersion=wt,z.needsLights&&(Tt.ambientLightColor.value=G.state.ambient,Tt.lightProbe.value=G.state.probe,Tt.sunLights.value=G.state.sun,Tt.sunLightShadows.value=G.state.sunShadow,Tt.directionalLights.value=G.state.directional,Tt.directionalLightShadows.value=G.state.directionalShadow,Tt.spotLights.value=G.state.spot,Tt.spotLightShadows.value=G.state.spotShadow,Tt.rectAreaLights.value=G.state.rectArea,Tt.ltc_1.value=G.state.rectAreaLTC1,Tt.ltc_2.value=G.state.rectAreaLTC2,Tt.pointLights.value=G.state.point,Tt.pointLightShadows.value=G.state.pointShadow,Tt.hemisphereLights.value=G.state.hemi,Tt.sunShadowMatrix.value=G.state.sunShadowMatrix,Tt.sunShadowCascade.value=G.state.sunShadowCascade,Tt.directionalShadowMatrix.value=G.state.directionalShadowMatrix,Tt.spotLightMatrix.value=G.state.spotLightMatrix,Tt.spotLightMap.value=G.state.spotLightMap,Tt.pointShadowMatrix.value=G.state.pointShadowMatrix),z.numLightProbeGrids=cu(C.state.lightProbeGridArray),z.currentProgram=qt,z.uniformsList=null,qt}function Em(S,N,$,z,G){let _t=It.get(S),wt=_t.currentProgram.id+","+z+","+G,mt=_t.programVariants.get(wt);return mt===void 0?(mt=Bs(S,N,$),_t.programVariants.set(wt,mt)):(_t.currentProgram=mt,_t.uniformsList=null,_t.outputColorSpace=z,_t.toneMapping=G),mt}function hu(S){if(S.uniformsList===null){let N=S.currentProgram.getUniforms();S.uniformsList=Ns.seqWithValue(N.seq,S.uniforms)}return S.uniformsList}function uu(S,N){let $=It.get(S);$.outputColorSpace=N.outputColorSpace,$.batching=N.batching,$.batchingColor=N.batchingColor,$.instancing=N.instancing,$.instancingColor=N.instancingColor,$.instancingMorph=N.instancingMorph,$.skinning=N.skinning,$.morphTargets=N.morphTargets,$.morphNormals=N.morphNormals,$.morphColors=N.morphColors,$.morphTargetsCount=N.morphTargetsCount,$.numClippingPlanes=N.numClippingPlanes,$.numIntersection=N.numClipIntersection,$.vertexAlphas=N.vertexAlphas,$.vertexTangents=N.vertexTangents,$.toneMapping=N.toneMapping}function Am(S,N,$,z,G){N.isScene!==!0&&(N=mn),Bt.resetTextureUnits();let _t=N.fog,wt=z.isMeshStandardMaterial||z.isMeshLambertMaterial||z.isMeshPhongMaterial?N.environment:null,mt=nt===null?L.outputColorSpace:nt.isXRRenderTarget===!0?nt.texture.colorSpace:Kt.workingColorSpace,bt=z.isMeshStandardMaterial||z.isMeshLambertMaterial&&!z.envMap||z.isMeshPhongMaterial&&!z.envMap,At=A.get(z.envMap||wt,bt),zt=z.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,qt=!!$.attributes.tangent&&(!!z.normalMap||z.anisotropy>0),Tt=!!$.morphAttributes.position,Yt=!!$.morphAttributes.normal,be=!!$.morphAttributes.color,de=Bn;z.toneMapped&&(nt===null||nt.isXRRenderTarget===!0)&&(de=L.toneMapping);let he=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,Ge=he!==void 0?he.length:0,Et=It.get(z),Ye=C.state.lights;if(we===!0&&(je===!0||S!==k)){let ve=S===k&&z.id===q;Q.setState(z,S,ve)}let ee=!1,Ci=!1;z.version===Et.__version?Et.needsLights&&Et.lightsStateVersion!==Ye.state.version||G.isBatchedMesh&&Et.batching===!1||!G.isBatchedMesh&&Et.batching===!0||G.isBatchedMesh&&Et.batchingColor===!0&&G._colorsTexture===null||G.isBatchedMesh&&Et.batchingColor===!1&&G._colorsTexture!==null||G.isInstancedMesh&&Et.instancing===!1||!G.isInstancedMesh&&Et.instancing===!0||G.isSkinnedMesh&&Et.skinning===!1||!G.isSkinnedMesh&&Et.skinning===!0||G.isInstancedMesh&&Et.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&Et.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&Et.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&Et.instancingMorph===!1&&G.morphTexture!==null||Et.envMap!==At||z.fog===!0&&Et.fog!==_t||Et.numClippingPlanes!==void 0&&(Et.numClippingPlanes!==Q.numPlanes||Et.numIntersection!==Q.numIntersection)||Et.vertexAlphas!==zt||Et.vertexTangents!==qt||Et.morphTargets!==Tt||Et.morphNormals!==Yt||Et.morphColors!==be||Et.morphTargetsCount!==Ge||Et.numLightProbeGrids!==cu(C.state.lightProbeGridArray)?ee=!0:(Et.outputColorSpace!==mt||Et.toneMapping!==de)&&(Ci=!0):(ee=!0,Et.__version=z.version);let He=Et.currentProgram;(ee===!0||Ci===!0)&&(He=Ci===!0?Em(z,N,G,mt,de):Bs(z,N,G),B&&z.isNodeMaterial&&B.onUpdateProgram(z,He,Et));let Kr=!1,si=!1,Ri=!1,te=He.getUniforms(),ke=Et.uniforms;if(xt.useProgram(He.program)&&(Kr=!0,si=!0,Ri=!0),z.id!==q&&(q=z.id,si=!0),Kr||k!==S){xt.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),te.setValue(F,"projectionMatrix",S.projectionMatrix),te.setValue(F,"viewMatrix",S.matrixWorldInverse);let Le=te.map.cameraPosition;Le!==void 0&&Le.setValue(F,Dn.setFromMatrixPosition(S.matrixWorld)),ge.logarithmicDepthBuffer&&te.setValue(F,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(z.isMeshPhongMaterial||z.isMeshToonMaterial||z.isMeshLambertMaterial||z.isMeshBasicMaterial||z.isMeshStandardMaterial||z.isShaderMaterial)&&te.setValue(F,"isOrthographic",S.isOrthographicCamera===!0),k!==S&&(k=S,si=!0,Ri=!0)}if(Et.needsLights&&(Ye.state.sunShadowMap.length>0&&te.setValue(F,"sunShadowMap",Ye.state.sunShadowMap,Bt),Ye.state.directionalShadowMap.length>0&&te.setValue(F,"directionalShadowMap",Ye.state.directionalShadowMap,Bt),Ye.state.spotShadowMap.length>0&&te.setValue(F,"spotShadowMap",Ye.state.spotShadowMap,Bt),Ye.state.pointShadowMap.length>0&&te.setValue(F,"pointShadowMap",Ye.state.pointShadowMap,Bt)),G.isSkinnedMesh){te.setOptional(F,G,"bindMatrix"),te.setOptional(F,G,"bindMatrixInverse");let ve=G.skeleton;ve&&(ve.boneTexture===null&&ve.computeBoneTexture(),te.setValue(F,"boneTexture",ve.boneTexture,Bt))}G.isBatchedMesh&&(te.setOptional(F,G,"batchingTexture"),te.setValue(F,"batchingTexture",G._matricesTexture,Bt),te.setOptional(F,G,"batchingIdTexture"),te.setValue(F,"batchingIdTexture",G._indirectTexture,Bt),te.setOptional(F,G,"batchingColorTexture"),G._colorsTexture!==null&&te.setValue(F,"batchingColorTexture",G._colorsTexture,Bt));let wn=$.morphAttributes;if((wn.position!==void 0||wn.normal!==void 0||wn.color!==void 0)&&tt.update(G,$,He),(si||Et.receiveShadow!==G.receiveShadow)&&(Et.receiveShadow=G.receiveShadow,te.setValue(F,"receiveShadow",G.receiveShadow)),(z.isMeshStandardMaterial||z.isMeshLambertMaterial||z.isMeshPhongMaterial)&&z.envMap===null&&N.environment!==null&&(ke.envMapIntensity.value=N.environmentIntensity),ke.dfgLUT!==void 0&&(ke.dfgLUT.value=Qv()),si){if(te.setValue(F,"toneMappingExposure",L.toneMappingExposure),Et.needsLights&&Cm(ke,Ri),_t&&z.fog===!0&&ht.refreshFogUniforms(ke,_t),ht.refreshMaterialUniforms(ke,z,lt,St,C.state.transmissionRenderTarget[S.id]),Et.needsLights&&Et.numLightProbeGrids>0){let ve=M,Le=0;for(let Gn of C.state.lightProbeGridArray)Gn.texture!==null&&(ve.textures[Le]=Gn.texture,ve.min[Le]=Gn.boundingBox.min,ve.max[Le]=Gn.boundingBox.max,ve.resolution[Le]=Gn.resolution,Le++);for(let Gn in ve)ve[Gn].length=Le;ke.probesSH.value=ve.textures,ke.probesMin.value=ve.min,ke.probesMax.value=ve.max,ke.probesResolution.value=ve.resolution}Ns.upload(F,hu(Et),ke,Bt)}if(z.isShaderMaterial&&z.uniformsNeedUpdate===!0&&(Ns.upload(F,hu(Et),ke,Bt),z.uniformsNeedUpdate=!1),z.isSpriteMaterial&&te.setValue(F,"center",G.center),te.setValue(F,"modelViewMatrix",G.modelViewMatrix),te.setValue(F,"normalMatrix",G.normalMatrix),te.setValue(F,"modelMatrix",G.matrixWorld),z.uniformsGroups!==void 0){let ve=z.uniformsGroups;for(let Le=0,Gn=ve.length;Le<Gn;Le++){let fu=ve[Le];Ct.update(fu,He),Ct.bind(fu,He)}}return He}function Cm(S,N){S.ambientLightColor.needsUpdate=N,S.lightProbe.needsUpdate=N,S.sunLights.needsUpdate=N,S.sunLightShadows.needsUpdate=N,S.directionalLights.needsUpdate=N,S.directionalLightShadows.needsUpdate=N,S.pointLights.needsUpdate=N,S.pointLightShadows.needsUpdate=N,S.spotLights.needsUpdate=N,S.spotLightShadows.needsUpdate=N,S.rectAreaLights.needsUpdate=N,S.hemisphereLights.needsUpdate=N}function Rm(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return J},this.getActiveMipmapLevel=function(){return X},this.getRenderTarget=function(){return nt},this.setRenderTargetTextures=function(S,N,$){let z=It.get(S);z.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,z.__autoAllocateDepthBuffer===!1&&(z.__useRenderToTexture=!1),It.get(S.texture).__webglTexture=N,It.get(S.depthTexture).__webglTexture=z.__autoAllocateDepthBuffer?void 0:$,z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,N){let $=It.get(S);$.__webglFramebuffer=N,$.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(S,N=0,$=0){nt=S,J=N,X=$;let z=null,G=!1,_t=!1;if(S){let mt=It.get(S);if(mt.__useDefaultFramebuffer!==void 0){xt.bindFramebuffer(F.FRAMEBUFFER,mt.__webglFramebuffer),Z.copy(S.viewport),dt.copy(S.scissor),at=S.scissorTest,xt.viewport(Z),xt.scissor(dt),xt.setScissorTest(at),q=-1;return}else if(mt.__webglFramebuffer===void 0)Bt.setupRenderTarget(S);else if(mt.__hasExternalTextures)Bt.rebindTextures(S,It.get(S.texture).__webglTexture,It.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let zt=S.depthTexture;if(mt.__boundDepthTexture!==zt){if(zt!==null&&It.has(zt)&&(S.width!==zt.image.width||S.height!==zt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Bt.setupDepthRenderbuffer(S)}}let bt=S.texture;(bt.isData3DTexture||bt.isDataArrayTexture||bt.isCompressedArrayTexture)&&(_t=!0);let At=It.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(At[N])?z=At[N][$]:z=At[N],G=!0):S.samples>0&&Bt.useMultisampledRTT(S)===!1?z=It.get(S).__webglMultisampledFramebuffer:Array.isArray(At)?z=At[$]:z=At,Z.copy(S.viewport),dt.copy(S.scissor),at=S.scissorTest}else Z.copy(Dt).multiplyScalar(lt).floor(),dt.copy(se).multiplyScalar(lt).floor(),at=ce;if($!==0&&(z=H),xt.bindFramebuffer(F.FRAMEBUFFER,z)&&xt.drawBuffers(S,z),xt.viewport(Z),xt.scissor(dt),xt.setScissorTest(at),G){let mt=It.get(S.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+N,mt.__webglTexture,$)}else if(_t){let mt=N;for(let bt=0;bt<S.textures.length;bt++){let At=It.get(S.textures[bt]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+bt,At.__webglTexture,$,mt)}}else if(S!==null&&$!==0){let mt=It.get(S.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,mt.__webglTexture,$)}q=-1};function du(S){let N=It.get(S);return(N.__readFormat!==S.format||N.__readType!==S.type)&&(N.__readFormat=S.format,N.__readType=S.type,N.__formatReadable=ge.textureFormatReadable(S.format),N.__typeReadable=ge.textureTypeReadable(S.type)),N}this.readRenderTargetPixels=function(S,N,$,z,G,_t,wt,mt=0){if(!(S&&S.isWebGLRenderTarget)){Nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let bt=It.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&wt!==void 0&&(bt=bt[wt],Array.isArray(bt)&&(bt=bt[0])),bt){xt.bindFramebuffer(F.FRAMEBUFFER,bt);try{let At=S.textures[mt],zt=At.format,qt=At.type;S.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+mt);let Tt=du(At);if(Tt.__formatReadable===!1){Nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Tt.__typeReadable===!1){Nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=S.width-z&&$>=0&&$<=S.height-G&&F.readPixels(N,$,z,G,ot.convert(zt),ot.convert(qt),_t)}finally{let At=nt!==null?It.get(nt).__webglFramebuffer:null;xt.bindFramebuffer(F.FRAMEBUFFER,At)}}},this.readRenderTargetPixelsAsync=async function(S,N,$,z,G,_t,wt,mt=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let bt=It.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&wt!==void 0&&(bt=bt[wt],Array.isArray(bt)&&(bt=bt[0])),bt)if(N>=0&&N<=S.width-z&&$>=0&&$<=S.height-G){xt.bindFramebuffer(F.FRAMEBUFFER,bt);let At=S.textures[mt],zt=At.format,qt=At.type;S.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+mt);let Tt=du(At);if(Tt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Tt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Yt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,Yt),F.bufferData(F.PIXEL_PACK_BUFFER,_t.byteLength,F.STREAM_READ),F.readPixels(N,$,z,G,ot.convert(zt),ot.convert(qt),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let be=nt!==null?It.get(nt).__webglFramebuffer:null;xt.bindFramebuffer(F.FRAMEBUFFER,be);let de=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Nf(F,de,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,Yt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,_t),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(Yt),F.deleteSync(de),_t}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,N=null,$=0){let z=Math.pow(2,-$),G=Math.floor(S.image.width*z),_t=Math.floor(S.image.height*z),wt=N!==null?N.x:0,mt=N!==null?N.y:0;Bt.setTexture2D(S,0),F.copyTexSubImage2D(F.TEXTURE_2D,$,0,0,wt,mt,G,_t),xt.unbindTexture()},this.copyTextureToTexture=function(S,N,$=null,z=null,G=0,_t=0){let wt,mt,bt,At,zt,qt,Tt,Yt,be,de=S.isCompressedTexture?S.mipmaps[_t]:S.image;if($!==null)wt=$.max.x-$.min.x,mt=$.max.y-$.min.y,bt=$.isBox3?$.max.z-$.min.z:1,At=$.min.x,zt=$.min.y,qt=$.isBox3?$.min.z:0;else{let te=Math.pow(2,-G);wt=Math.floor(de.width*te),mt=Math.floor(de.height*te),S.isDataArrayTexture?bt=de.depth:S.isData3DTexture?bt=Math.floor(de.depth*te):bt=1,At=0,zt=0,qt=0}z!==null?(Tt=z.x,Yt=z.y,be=z.z):(Tt=0,Yt=0,be=0);let he=ot.convert(N.format),Ge=ot.convert(N.type),Et;N.isData3DTexture?(Bt.setTexture3D(N,0),Et=F.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(Bt.setTexture2DArray(N,0),Et=F.TEXTURE_2D_ARRAY):(Bt.setTexture2D(N,0),Et=F.TEXTURE_2D),xt.activeTexture(F.TEXTURE0),xt.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,N.flipY),xt.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),xt.pixelStorei(F.UNPACK_ALIGNMENT,N.unpackAlignment);let Ye=xt.getParameter(F.UNPACK_ROW_LENGTH),ee=xt.getParameter(F.UNPACK_IMAGE_HEIGHT),Ci=xt.getParameter(F.UNPACK_SKIP_PIXELS),He=xt.getParameter(F.UNPACK_SKIP_ROWS),Kr=xt.getParameter(F.UNPACK_SKIP_IMAGES);xt.pixelStorei(F.UNPACK_ROW_LENGTH,de.width),xt.pixelStorei(F.UNPACK_IMAGE_HEIGHT,de.height),xt.pixelStorei(F.UNPACK_SKIP_PIXELS,At),xt.pixelStorei(F.UNPACK_SKIP_ROWS,zt),xt.pixelStorei(F.UNPACK_SKIP_IMAGES,qt);let si=S.isDataArrayTexture||S.isData3DTexture,Ri=N.isDataArrayTexture||N.isData3DTexture;if(S.isDepthTexture){let te=It.get(S),ke=It.get(N),wn=It.get(te.__renderTarget),ve=It.get(ke.__renderTarget);xt.bindFramebuffer(F.READ_FRAMEBUFFER,wn.__webglFramebuffer),xt.bindFramebuffer(F.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let Le=0;Le<bt;Le++)si&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,It.get(S).__webglTexture,G,qt+Le),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,It.get(N).__webglTexture,_t,be+Le)),F.blitFramebuffer(At,zt,At+wt,zt+mt,Tt,Yt,Tt+wt,Yt+mt,F.DEPTH_BUFFER_BIT,F.NEAREST);xt.bindFramebuffer(F.READ_FRAMEBUFFER,null),xt.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(G!==0||S.isRenderTargetTexture||It.has(S)){let te=It.get(S),ke=It.get(N);xt.bindFramebuffer(F.READ_FRAMEBUFFER,D),xt.bindFramebuffer(F.DRAW_FRAMEBUFFER,Y);for(let wn=0;wn<bt;wn++)si?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,te.__webglTexture,G,qt+wn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,te.__webglTexture,G),Ri?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ke.__webglTexture,_t,be+wn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ke.__webglTexture,_t),G!==0?F.blitFramebuffer(At,zt,At+wt,zt+mt,Tt,Yt,Tt+wt,Yt+mt,F.COLOR_BUFFER_BIT,F.NEAREST):Ri?F.copyTexSubImage3D(Et,_t,Tt,Yt,be+wn,At,zt,wt,mt):F.copyTexSubImage2D(Et,_t,Tt,Yt,At,zt,wt,mt);xt.bindFramebuffer(F.READ_FRAMEBUFFER,null),xt.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Ri?S.isDataTexture||S.isData3DTexture?F.texSubImage3D(Et,_t,Tt,Yt,be,wt,mt,bt,he,Ge,de.data):N.isCompressedArrayTexture?F.compressedTexSubImage3D(Et,_t,Tt,Yt,be,wt,mt,bt,he,de.data):F.texSubImage3D(Et,_t,Tt,Yt,be,wt,mt,bt,he,Ge,de):S.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,_t,Tt,Yt,wt,mt,he,Ge,de.data):S.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,_t,Tt,Yt,de.width,de.height,he,de.data):F.texSubImage2D(F.TEXTURE_2D,_t,Tt,Yt,wt,mt,he,Ge,de);xt.pixelStorei(F.UNPACK_ROW_LENGTH,Ye),xt.pixelStorei(F.UNPACK_IMAGE_HEIGHT,ee),xt.pixelStorei(F.UNPACK_SKIP_PIXELS,Ci),xt.pixelStorei(F.UNPACK_SKIP_ROWS,He),xt.pixelStorei(F.UNPACK_SKIP_IMAGES,Kr),_t===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&F.generateMipmap(Et),xt.unbindTexture()},this.initRenderTarget=function(S){It.get(S).__webglFramebuffer===void 0&&Bt.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Bt.setTextureCube(S,0):S.isData3DTexture?Bt.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Bt.setTexture2DArray(S,0):Bt.setTexture2D(S,0),xt.unbindTexture()},this.resetState=function(){J=0,X=0,nt=null,xt.reset(),ut.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return bn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Kt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Kt._getUnpackColorSpace()}};function Mn(i,t){let e=i.slice(12*t,12*t+12);return new Qt().set(e[0],e[1],e[2],e[9],e[3],e[4],e[5],e[10],e[6],e[7],e[8],e[11],0,0,0,1)}function ae(i,t,e){return new R(...e).applyMatrix4(Mn(i,t))}function Gr(i,t,e){return new R(...e).transformDirection(Mn(i,t)).multiplyScalar(Math.hypot(...e))}function Us(i,t,e){let n=e.length();return n===0?e.clone():e.clone().transformDirection(Mn(i,t).transpose().setPosition(0,0,0)).multiplyScalar(n)}function Vh(i,t,e){let n=[];i.links.forEach((s,r)=>{for(let l of s.lines)for(let c of l)n.push(ae(t,r,c));s.com&&s.mass>0&&n.push(ae(t,r,s.com));let o=e[r],a=o?3*Math.max(1,Math.floor(o.length/3/600)):1;for(let l=0;o&&l+2<o.length;l+=a)n.push(ae(t,r,[o[l],o[l+1],o[l+2]]))});for(let s of i.wheels){let r=new Ue().setFromUnitVectors(new R(0,0,1),new R(...s.axis).normalize());for(let o=0;o<12;o++){let a=new R(Math.cos(o*Math.PI/6),Math.sin(o*Math.PI/6),0).applyQuaternion(r).multiplyScalar(s.radius);n.push(ae(t,s.link,a.add(new R(...s.centre)).toArray()))}}for(let s of i.sheet?.hardpoints??[])n.push(ae(t,s.link,s.point));return n.length?n:[new R(-1,-1,-1),new R(1,1,1)]}var Wi=["#0b78b8","#00936b","#c0609a","#a87900","#3f9fd8","#8a63d2","#947243","#6b7785"],Vr=["#c3ced9","#e3b98d","#e08a3c","#b83a0f"].map(i=>new kt(i));function Xi(i){let t=Math.min(Math.max(i,0),1)*(Vr.length-1),e=Math.min(Math.floor(t),Vr.length-2);return Vr[e].clone().lerp(Vr[e+1],t-e)}function Gh(){return Vr.map(i=>`#${i.getHexString()}`).join(", ")}function vp(i){if(!i)return null;let t=Uint8Array.from(atob(i),e=>e.charCodeAt(0));return new Float32Array(t.buffer)}function bp(i,t){let[e,n,s]=[new R,new R,new R];return t.flatMap((r,o)=>{if(!r?.length)return[];let a=[];for(let l=0;l+8<r.length;l+=9){e.fromArray(r,l),n.fromArray(r,l+3),s.fromArray(r,l+6);let c=e.clone().add(n).add(s).multiplyScalar(1/3),h=n.clone().sub(e).cross(s.clone().sub(e)).normalize();a.push([...c.toArray(),...(h.length()>0?h:new R(0,0,1)).toArray()])}return[{link:o,name:i.links[o].name,contacts:a}]})}var tb=Symbol.for("pv"),eb=0;function p(i,t,e,n,s,r){t||(t={});var o,a,l=t;if("ref"in l&&typeof i!="function")for(a in l={},t)a=="ref"?o=t[a]:l[a]=t[a];var c={type:i,props:l,key:e,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:tb,__v:--eb,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),oe.vnode&&oe.vnode(c),c}function Sp(i,t,e){let n=sn(void 0);return{isOpen:()=>n.current!==void 0,from:()=>n.current??t,apply:r=>{Number.isFinite(r)&&(n.current===void 0&&E.begin(i),n.current=r,e(r))},end:r=>{n.current!==void 0&&E.finish(r),n.current=void 0}}}function Ei({label:i,value:t,decimals:e,step:n,title:s,changed:r,disabled:o,set:a}){let[l,c]=le(void 0),h=Sp(i,t,a),f=Number(t.toFixed(e))+0,u=()=>{c(void 0),h.end(!0)};return p("input",{type:"text",inputMode:"decimal",autocomplete:"off",class:r?"number changed":"number","aria-label":i,title:s,disabled:o,value:l??f.toFixed(e),onInput:d=>{let g=d.currentTarget.value;c(g);let x=Number(g.replace(",",".").replace("−","-"));g.trim()!==""&&h.apply(x)},onKeyDown:d=>{let g={ArrowUp:1,ArrowDown:-1}[d.key];if(g){d.preventDefault(),c(void 0);let x=n*(d.shiftKey?10:1);h.apply(Math.round((h.from()+g*x)/n)*n)}else d.key==="Enter"?u():d.key==="Escape"&&h.isOpen()&&(d.stopPropagation(),c(void 0),h.end(!1))},onBlur:u})}function bl({label:i,value:t,hint:e,class:n,set:s}){let[r,o]=le(void 0);return p("input",{class:n,type:"text",autocomplete:"off","aria-label":i,placeholder:e,value:r??t,onInput:a=>o(a.currentTarget.value),onChange:a=>{s(a.currentTarget.value),o(void 0)}})}function Mp({label:i,value:t,range:e,step:n,set:s,text:r,disabled:o}){let a=Sp(i,t,s),l=()=>a.end(!0);return p("input",{type:"range","aria-label":i,"aria-valuetext":r,min:e[0],max:e[1],step:"any",value:t,disabled:o,onInput:c=>a.apply(Math.round(Number(c.currentTarget.value)/(n/5))*(n/5)),onKeyDown:c=>{let h={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[c.key];if(h===void 0&&c.key!=="Home"&&c.key!=="End")return;c.preventDefault();let f=h===void 0?e[c.key==="Home"?0:1]:a.from()+h*n*(c.shiftKey?10:1);a.apply(Math.min(Math.max(Math.round(f/n)*n,e[0]),e[1]))},onKeyUp:l,onChange:l,onBlur:l})}function wp(){let{posed:i,problem:t,study:e,opened:n}=Zt();if(!n||!e)return null;let s=i?.report;return p("section",{class:"result","aria-label":"Result",children:[s?p(sb,{report:s,stale:t!==void 0}):null,t?p(ab,{}):null,s&&!t?p(lb,{report:s}):null]})}var nb=5e-5,ib=1e-6;function sb({report:i,stale:t}){let{contact:e,named_contact:n}=i,s=i.effective_mass,r=i.effective_mass_error,o=i.status==="immovable"?"∞":i.status==="massless"?"0":Nn(s,r),a=`± ${Ju(r??0)} ${i.unit}: rounding, closing of the loops, and loops that the file leaves open`;return p("div",{class:t?"stale":"",children:[p("p",{class:"kind",children:[e.is_moment?"effective inertia":"effective mass"," ",p("i",{children:"m̄"})," at ",p("b",{children:Xt(n?n.name:e.link)})]}),p("p",{class:"big",role:"status","aria-live":"polite","data-mass":s??i.status,title:s!==null&&r!==null?a:void 0,children:[i.singular_pose&&s!==null?p("span",{class:"symbol",children:"≥ "}):null,p("b",{children:o})," ",i.status==="immovable"?"":i.unit]}),p("p",{class:"sub",children:rb(i)}),p("p",{class:"sub",children:p("span",{class:"tag",children:ob(i)})}),i.singular_pose?p("p",{class:"sub",children:"a bound for all branches"}):s&&r!==null&&r>ib*s?p("p",{class:"sub",children:a}):null,i.other_base?p("p",{class:"sub",children:["With the ",Xt(i.other_base.link)," ",i.other_base.base==="floating"?"free":"fixed",": ",p("b",{children:i.other_base.effective_mass===null?i.other_base.status:`${Nn(i.other_base.effective_mass,i.other_base.effective_mass_error)} ${i.unit}`}),"."]}):null,n?.effective_mass_together!=null?p("p",{class:"sub both",children:["Both stops (",[n.name,...n.touching].map(Xt).join(", "),"), closing together: ",p("b",{children:[Nn(n.effective_mass_together,r)," ",i.unit]})," each."]}):null]})}function rb({contact:i,conditions:t,named_contact:e,motion_ratios:n,status:s,unit:r,effective_mass:o,effective_mass_error:a}){let l=E.scene.links.reduce((d,g,x)=>d+(x===E.scene.root&&t.base==="fixed"?0:g.mass),0),c=n.find(d=>d.contact_per_wheel!==null&&d.link.startsWith("wheel_centre"))?.contact_per_wheel,h=`the ${i.against?Xt(i.against):"ground"}`,f=s!=="finite"||i.is_moment?"":e?.kind==="spring"||e?.kind==="damper"?`The ${Xt(e.name)} feels the mechanism of ${Jt(l,4)} kg like a mass of ${Nn(o,a,4)} ${r}.`:`The mechanism of ${Jt(l,4)} kg strikes ${e?`the ${Xt(e.name)}`:h} like a mass of ${Nn(o,a,4)} ${r}.`,u=c!=null?` It moves ${Ot(Math.abs(c),4)} times as far as the wheel.`:"";return`${f}${u} Between the ${Xt(i.link)} and ${h}.`}function ob({named_contact:i,conditions:t}){let e=[...new Set((i?.wheel_travel??[]).filter(({travel:r})=>Math.abs(r)>nb).map(({travel:r})=>`${Ot(Math.abs(r)*1e3,1)} mm ${r<0?"down":"up"}`))],n=E.study.pose;return[i?.brought_to_touch?"at the touch":Object.keys(n.set??{}).length||n.travel?.length||n.file?"at the pose shown":"at the design position",e.length?`wheel ${e.join(", ")}`:"",i?.gap!=null&&!i.brought_to_touch?i.gap<0?`${Ot(-i.gap*1e3,1)} mm beyond the touch`:`gap ${Ot(i.gap*1e3,1)} mm`:"",`base ${t.base}`].filter(Boolean).join(" · ")}function ab(){let{problem:i,driver:t,study:e}=E,n=t&&E.curve&&"ok"in E.curve?E.curve.ok.rows.filter(r=>r.status!=="unreachable"&&r.status!=="no answer"):[],s=n.length&&i.no_result?[n[0].at,n.at(-1).at]:void 0;return p("div",{class:"box bad",role:"alert",children:[p("p",{children:[p("b",{children:i.no_result?"No result here.":"Refused."})," ",i.message]}),E.posed?p("p",{class:"soft",children:"The last result is shown in grey."}):null,p("p",{class:"row",children:[s&&t&&s.map((r,o)=>p("button",{onClick:()=>E.change(on(e,t,r),`to the end of ${t.label}`),children:[t.label," to ",Ot(r*t.unit.perSi,1)," ",t.unit.name]},o)),E.lastLabel?p("button",{onClick:()=>E.inGesture?E.finish(!1):E.undo(),children:["Undo “",E.lastLabel,"”"]}):null]})]})}function lb({report:i}){let{study:t,driver:e}=E;if(i.status==="immovable"){let n=t.conditions.lock??[],s=t.hold?.length??0;return p("div",{class:"box",children:[p("p",{children:[p("b",{children:"Immovable."})," No motion that the joints and loops permit closes this gap, so the contact acts as on a wall.",n.length?` Locked joints: ${n.join(", ")}.`:"",s?` Held points: ${s}.`:""]}),p("p",{class:"row",children:[n.map(r=>p("button",{onClick:()=>E.change({...t,conditions:{...t.conditions,lock:n.filter(o=>o!==r)}},`unlock ${r}`),children:["Unlock ",r]},r)),s?p("button",{onClick:()=>E.change({...t,hold:[]},"release all points"),children:"Release the held points"}):null,t.conditions.base!=="floating"?p("button",{onClick:()=>E.change({...t,conditions:{...t.conditions,base:"floating"}},"free the base"),children:"Let the base move freely"}):null]}),p("p",{class:"soft",children:"Or turn the normal: drag the head of the arrow, or choose another axis in the tab Result."})]})}if(i.status==="massless")return p("div",{class:"box",children:[p("p",{children:[p("b",{children:"Massless."})," A motion without mass closes this gap: the link at the contact moves, and no link with mass moves with it."]}),p("p",{class:"soft",children:"Give the links of this motion a mass (tab Design), or turn the normal."})]});if(i.singular_pose){let n=i.branch_limits.map(s=>s===null?"immovable":`${Jt(s)} ${i.unit}`);return p("div",{class:"box warn",children:[p("p",{children:[p("b",{children:"Singular pose."})," Branches of the linkage cross or end here, and m̄ depends on the branch",n.length?`: ${n.join(", ")} along the branches.`:"."]}),e?p("p",{class:"row",children:[-1,1].map(s=>{let r=Sl()+s*e.unit.step/e.unit.perSi/5;return p("button",{onClick:()=>E.change(on(t,e,r),"off the singular pose"),children:[De(s*e.unit.step/5,1)," ",e.unit.name," of ",e.label]},s)})}):null]})}return null}function Sl(){let{driver:i,study:t}=E;return i&&t?E.positionOf(i):0}function Tp(i){let[t,e]=le({width:600,height:200});return Qe(()=>{let n=new ResizeObserver(([s])=>{let{width:r,height:o}=s.contentRect;e({width:Math.round(r),height:Math.round(o)})});return n.observe(i.current),()=>n.disconnect()},[]),t}var Gt={left:70,right:18,top:14,bottom:40},cb=480,hb=6;function Ap(){let{driver:i,drivers:t,opened:e}=Zt();if(!e)return null;if(!i)return p("section",{class:"curve empty",children:p("p",{class:"soft",children:"No joint with a single position can be set: the model has no curve."})});let n=E.curve&&"refused"in E.curve?E.curve.refused.message:void 0;return p("section",{class:"curve","aria-label":`m̄ over ${i.label}`,children:[p("div",{class:"curve-head",children:[p("label",{children:["effective mass m̄ over"," ",p("select",{value:i.name,onChange:s=>E.chooseDriver(s.currentTarget.value),children:t.map(s=>p("option",{value:s.name,children:s.label},s.name))})]}),p(ub,{}),p(db,{})]}),p(fb,{}),n?p("p",{class:"box bad",children:n}):p(pb,{})]})}function ub(){let i=E.variants.filter(t=>t.curve);return i.length?p("span",{class:"keys",children:[p("svg",{width:"26",height:"8","aria-hidden":"true",children:p("path",{d:"M0 4h26",class:"trace now"})})," now",i.map(t=>p("span",{children:[p("svg",{width:"26",height:"8","aria-hidden":"true",children:p("path",{d:"M0 4h26",class:"trace frozen",style:{stroke:Wi[t.colour]}})})," ",t.name]},t.name))]}):null}function db(){let[i,t]=le(!1),{target:e,tolerance:n,posed:s}=E,r=s?.report.effective_mass??1,o=s?.report.unit??"kg";if(!i&&!e&&!n)return p("button",{class:"quiet",onClick:()=>t(!0),children:"Target, tolerance …"});let[a,l]=e??[.9*r,1.1*r],c=Math.max(0,2-Math.floor(Math.log10(Math.max(Math.abs(r),1e-9)))),h=(f,u,d)=>p(Ep,{label:f,value:Number(u.toFixed(c)),set:d});return p("span",{class:"bands",children:[p("label",{children:[p("input",{type:"checkbox",checked:e!==void 0,onChange:f=>E.set({target:f.currentTarget.checked?[a,l]:void 0})})," target"]}),e?p(jt,{children:[h(`target from, ${o}`,a,f=>E.set({target:[f,l]})),"–",h(`target to, ${o}`,l,f=>E.set({target:[a,f]}))," ",o]}):null,E.scene?.sheet?p(jt,{children:[p("label",{children:[p("input",{type:"checkbox",checked:n!==void 0,onChange:f=>E.setTolerance(f.currentTarget.checked?.001:void 0)})," tolerance"]}),n?p(jt,{children:["±",p(Ep,{label:"tolerance of the hardpoints, mm",value:Number((n*1e3).toFixed(3)),set:f=>E.setTolerance(f>0?f/1e3:void 0)})," mm"]}):null]}):null]})}function Ep({label:i,value:t,set:e}){return p(bl,{class:"number",label:i,value:String(t),set:n=>{let s=Number(n.replace(",","."));Number.isFinite(s)&&e(s)}})}function fb(){let{driver:i,ends:t,target:e,variation:n,posed:s}=E,r=Ml();if(!i||!r)return null;let o=od(r,i,t);if(e){let a=ad(r.rows,e).map(l=>l.map(c=>Ot(c*i.unit.perSi,1)).join(" to "));o.push(a.length?`Inside of the target from ${a.join(", and from ")} ${i.unit.name}.`:"Nowhere inside of the target.")}if(n?.length&&s){let a=E.positionOf(i),l=n.reduce((c,h)=>Math.abs(h.at-a)<Math.abs(c.at-a)?h:c);o.push(`Within the tolerance, to first order, m̄ varies by ±${Jt(l.rss,3)} ${s.report.unit} (independent coordinates) and by at most ±${Jt(l.worst,3)} ${s.report.unit} (all at their limits) at ${Ot(l.at*i.unit.perSi,1)} ${i.unit.name}.`)}return o.length?p("p",{class:"remarks",role:"status",children:o.join(" ")}):null}var Ml=()=>E.curve&&"ok"in E.curve?E.curve.ok:void 0;function pb(){let i=sn(null),{width:t,height:e}=Tp(i),[n,s]=le(!1),r=E.driver,o=Ml(),a=Sl(),l=r.unit.perSi,[c,h]=r.range.map(k=>k*l),u=[o,...E.variants.map(k=>k.curve)].filter(k=>!!k).flatMap(k=>k.rows.map(Z=>Z.mass).filter(Z=>Z!==null)).sort((k,Z)=>k-Z),d=E.posed?.report,g=d?.effective_mass??void 0,{target:x,variation:m}=E;x&&u.push(...x);for(let k of m??[])u.push(k.mass-k.worst,k.mass+k.worst);g!==void 0&&u.push(g),u.sort((k,Z)=>k-Z);let _=u[Math.floor(u.length/2)]??1,v=Math.min(u.at(-1)??1,Math.max(hb*_,g??0)),w=u[0]??0,M=Math.max(v-w,.001*Math.abs(v),1e-12)*.08,[P,C]=[w-M<0&&w>=0?0:w-M,v+M],y=k=>Gt.left+(k-c)/(h-c)*(t-Gt.left-Gt.right),T=k=>Gt.top+(C-k)/(C-P)*(e-Gt.top-Gt.bottom),U=k=>{let Z="M";return k.rows.map(dt=>{if(dt.mass===null||dt.singular)return Z="M","";let at=`${Z}${y(dt.at*l).toFixed(1)} ${T(Math.min(dt.mass,C*4)).toFixed(1)}`;return Z="L",at}).join("")},L=nc(P,C,Math.max(3,Math.floor((e-54)/30))),O=Math.max(0,-Math.floor(Math.log10((L[1]??1)-(L[0]??0))+1e-9)),B=nc(c,h,Math.max(3,Math.floor((t-80)/62))),H=k=>{let Z=r.unit.step/l/5,dt=Math.min(Math.max(k,r.range[0]),r.range[1]);E.change(on(E.study,r,Math.round(dt/Z)*Z),r.label)},D=k=>{let Z=i.current.getBoundingClientRect(),dt=(k.clientX-Z.left-Gt.left)/(t-Gt.left-Gt.right);return r.range[0]+dt*(r.range[1]-r.range[0])},Y=k=>{let Z=dt=>m.map(at=>`${y(at.at*l).toFixed(1)} ${T(at.mass+dt*at[k]).toFixed(1)}`);return`M${[...Z(1),...Z(-1).reverse()].join("L")}Z`},J=o?mb(o):[],X=r.isMotion&&r.name!=="roll"?Xs(E.contacts):[],nt=a*l>=c-1e-9&&a*l<=h+1e-9,q=`${r.label}, ${r.unit.name}`;return p("div",{ref:i,class:n?"plot dragging":"plot",role:"slider",tabIndex:0,"aria-label":`${r.label} in the curve`,"aria-valuemin":c,"aria-valuemax":h,"aria-valuenow":Number(Ot(a*l,2).replace("−","-")),"aria-valuetext":`${Ot(a*l,1)} ${r.unit.name}, m̄ ${g===void 0?d?.status??"none":`${Jt(g)} ${d?.unit??"kg"}`}`,onPointerDown:k=>{k.currentTarget.setPointerCapture(k.pointerId),E.begin(r.label),s(!0),H(D(k))},onPointerMove:k=>n&&H(D(k)),onPointerUp:()=>{s(!1),E.finish()},onPointerCancel:()=>{s(!1),E.finish(!1)},onKeyDown:k=>{let Z={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[k.key];if(!Z)return;k.preventDefault();let dt=r.unit.step/l;H(Math.round((Sl()+Z*dt*(k.shiftKey?10:1))/dt)*dt)},children:p("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,"aria-hidden":"true",class:"figure",children:[p("defs",{children:[p("pattern",{id:"hatch",width:"7",height:"7",patternUnits:"userSpaceOnUse",patternTransform:"rotate(45)",children:p("path",{d:"M0 0v7",class:"hatch"})}),p("clipPath",{id:"inner",children:p("rect",{x:Gt.left,y:Gt.top,width:Math.max(0,t-Gt.left-Gt.right),height:Math.max(0,e-Gt.top-Gt.bottom)})})]}),L.map(k=>p("g",{children:[p("path",{d:`M${Gt.left} ${T(k)}H${t-Gt.right}`,class:"grid"}),p("text",{x:Gt.left-8,y:T(k)+4,"text-anchor":"end",children:Ot(k,Math.min(6,O))})]},k)),B.map(k=>p("g",{children:[p("path",{d:`M${y(k)} ${e-Gt.bottom}v5`,class:"tick"}),p("text",{x:y(k),y:e-Gt.bottom+18,"text-anchor":"middle",children:rn(k).replace("-","−")})]},k)),p("path",{d:`M${Gt.left} ${e-Gt.bottom}H${t-Gt.right}`,class:"axis"}),p("text",{x:(Gt.left+t-Gt.right)/2,y:e-5,"text-anchor":"middle",class:"name",children:q}),p("text",{transform:`translate(14,${(Gt.top+e-Gt.bottom)/2}) rotate(-90)`,"text-anchor":"middle",class:"name",children:["m̄, ",d?.unit??"kg"]}),p("g",{"clip-path":"url(#inner)",children:[x?p("rect",{x:Gt.left,y:T(x[1]),width:Math.max(0,t-Gt.left-Gt.right),height:Math.max(0,T(x[0])-T(x[1])),class:"target"}):null,m?.length?p(jt,{children:[p("path",{d:Y("worst"),class:"within worst"}),p("path",{d:Y("rss"),class:"within"})]}):null,J.map(({from:k,to:Z,why:dt})=>p("g",{children:[p("rect",{x:y(k*l),y:Gt.top,width:Math.max(2,y(Z*l)-y(k*l)),height:Math.max(0,e-Gt.top-Gt.bottom),fill:"url(#hatch)"}),y(Z*l)-y(k*l)>90?p("text",{x:(y(k*l)+y(Z*l))/2,y:Gt.top+16,"text-anchor":"middle",class:"why",children:dt}):null]},k)),o?.rows.filter(k=>k.singular).map(k=>p("path",{d:`M${y(k.at*l)} ${Gt.top}V${e-Gt.bottom}`,class:"change"},k.at)),E.variants.map(k=>k.curve&&p("path",{d:U(k.curve),class:"trace frozen",style:{stroke:Wi[k.colour]}},k.name)),o?p("path",{d:U(o),class:"trace now"}):null,X.map(({name:k,travel:Z},dt)=>{let at=y(Z*l)>t/2;return p("g",{class:"touch","data-touch":k,"data-travel":Z,children:[p("path",{d:`M${y(Z*l)} ${Gt.top}V${e-Gt.bottom}`}),p("text",{x:y(Z*l)+(at?-5:5),y:Gt.top+10+(t<cb?14*dt:0),"text-anchor":at?"end":"start",children:[Xt(k)," touches, ",De(Z*l,1)]})]},`${k}${Z}`)}),nt?p("path",{d:`M${y(a*l)} ${Gt.top}V${e-Gt.bottom}`,class:"cursor"}):null,nt&&g!==void 0&&!E.problem&&!d?.singular_pose?p("circle",{cx:y(a*l),cy:T(g),r:"5.5",class:"marker"}):null]})]})})}function mb(i){let t=[],{rows:e}=i,n=e.length>1?(e[1].at-e[0].at)/2:0;return e.forEach((s,r)=>{if(s.mass!==null)return;let o={unreachable:"out of reach",immovable:"immovable",massless:"massless"}[s.status]??"no result",a=t.at(-1);a&&e[r-1]?.mass===null&&a.why===o?a.to=s.at+n:t.push({from:s.at-n,to:s.at+n,why:o})}),t}function Hr(i,t,e){let n=document.createElement("a");n.href=URL.createObjectURL(new Blob([t],{type:e})),n.download=i,n.click(),setTimeout(()=>URL.revokeObjectURL(n.href),1e3)}async function Xr(i){try{return await navigator.clipboard.writeText(i),!0}catch{let t=document.createElement("textarea");t.value=i,document.body.append(t),t.select();let e=document.execCommand("copy");return t.remove(),e}}var Wr=()=>E.fileName.replace(/.*[\\/]/,"").replace(/\.[^.]*$/,"")||"percuss";function gb(){let i=document.querySelector(".plot svg");if(!i)return;let t=i.cloneNode(!0);t.setAttribute("xmlns","http://www.w3.org/2000/svg"),i.classList.add("paper");let e=[i,...i.querySelectorAll("*")];return[t,...t.querySelectorAll("*")].forEach((n,s)=>{let r=getComputedStyle(e[s]);for(let o of["fill","stroke","stroke-width","stroke-dasharray","font-size","font-family","font-weight"])n.setAttribute(o,r.getPropertyValue(o));n.removeAttribute("class")}),i.classList.remove("paper"),t.outerHTML}function _b(){let i=Ml();if(!i)return;let t=i.unit?` [${i.unit}]`:"",e=i.rows.map(s=>[rn(s.at),s.status,s.mass??"",s.error??"",s.gap??""].join(","));return`${/[",\n]/.test(i.name)?`"${i.name.replaceAll('"','""')}"`:i.name}${t},status,effective_mass [kg],error [kg],gap [m]
${e.join(`
`)}
`}function xb(){let{study:i,text:t,files:e,fileName:n,shapes:s,driver:r,view:o}=E,a=JSON.stringify({model:{name:n,text:t,files:e,shapes:s},study:i,driver:r?.name,view:o}).replaceAll("<","\\u003c"),l=document.documentElement.cloneNode(!0);return l.querySelector("#start").textContent=a,l.querySelector("#app").innerHTML="",`<!DOCTYPE html>
${l.outerHTML}
`}async function Hh(){let i=await E.sheetText();i&&Hr(`${Wr()}-changed.toml`,i,"text/plain")}function Cp({png:i}){let{study:t,driver:e,scene:n}=Zt(),[s,r]=le("Command"),[o,a]=le("");if(!t||!n)return null;let l={Command:()=>pd(t),Study:()=>gc(t,e&&Ki(e,fc)),Python:()=>_d(t)}[s](),c=h=>{a(h),setTimeout(()=>a(""),1500)};return p("section",{children:[p("h2",{children:"The same elsewhere"}),p("div",{class:"tabs",role:"tablist",children:[["Command","Study","Python"].map(h=>p("button",{role:"tab","aria-selected":s===h,onClick:()=>r(h),children:h},h)),p("button",{class:"copy",onClick:async()=>c(await Xr(l)?"Copied":"Not permitted"),children:o||"Copy"})]}),p("pre",{class:"text",tabIndex:0,"aria-label":s,children:l}),p("p",{class:"row",children:[p("button",{onClick:()=>{let h=_b();h&&Hr(`${Wr()}-curve.csv`,h,"text/csv")},children:"Curve CSV"}),p("button",{onClick:()=>{let h=gb();h&&Hr(`${Wr()}-curve.svg`,h,"image/svg+xml")},children:"Curve SVG"}),p("button",{onClick:async()=>{let h=i();if(!h)return E.set({notice:"This browser draws no picture of the view: it has no WebGL."});let f=Uint8Array.from(atob(h.split(",")[1]),u=>u.charCodeAt(0));Hr(`${Wr()}-view.png`,f,"image/png")},children:"View PNG"}),n.sheet?.hardpoints.length?p("button",{onClick:Hh,children:"Changed sheet"}):null,p("button",{onClick:()=>Hr(`${Wr()}.html`,xb(),"text/html"),children:"Save page"})]})]})}function Rp(){let{folder:i}=Zt(),t=sn(null);if(Qe(()=>{i&&t.current?.showModal()},[i]),!i)return null;let e=()=>E.set({folder:void 0});return p("dialog",{ref:t,class:"chooser","aria-label":"Models of the folder",onClose:e,children:[p("h2",{children:[i.models.length," models in the folder"]}),p("ul",{children:i.models.map(n=>{let[,s,r]=/^(.*\/)?([^/]*)$/.exec(n.path);return p("li",{children:p("button",{onClick:()=>{E.openFromFolder(n,i.files)},children:[p("b",{children:r})," ",p("span",{class:"soft",children:[n.kind,n.within?`, included in ${n.within.replace(/.*\//,"")}`:""]}),s?p("span",{class:"soft place",children:s}):null]})},n.path)})}),p("p",{class:"row",children:p("button",{onClick:e,children:"Cancel"})})]})}function Pp(){let{past:i,variants:t,scene:e,hidesHints:n,choosing:s}=Zt();if(n||!e)return null;let r=l=>i.some(c=>l.test(c.label)),o=!!e.sheet,a=[[e.contacts.length?"Choose a contact above":"Click a link: contact there",r(/contact/)],[o?"Drag a ring: m̄ follows":"Drag a link: m̄ follows",r(o?/mm [xyz]|^move /:/^drag /)],["Keep as A, then compare",t.length>0]];return s||a.every(([,l])=>l)?null:p("p",{class:"hints",children:[a.map(([l,c],h)=>p("span",{class:c?"done":"",children:[p("b",{children:h+1}),l]},l)),p("button",{onClick:()=>E.set({hidesHints:!0}),children:"Hide"})]})}function Ip(i){return i?i.status!=="finite"?i.status==="immovable"?"∞":"0 kg":`${Nn(i.effective_mass,i.effective_mass_error,4)} ${i.unit}`:"–"}function yb({kind:i,report:t,problem:e}){if(i!=="stop")return"design position";let n=t?.named_contact;if(e||!n?.brought_to_touch)return e?"not reached":"";let s=[...new Set(n.wheel_travel.map(({travel:r})=>`${Ot(r*1e3,1)} mm`))];return s.length?`touch at ${s.join(", ")}`:"at the touch"}function Lp(){let{study:i,contacts:t,posed:e,problem:n,opened:s,choosing:r}=Zt();if(!s||!i)return null;let o=E.contactsAreFresh,a=!i.contact.at||!t.some(({name:h})=>h===i.contact.at),l=h=>{let{travel:f,...u}=i.pose;E.change({...i,contact:{at:h},pose:u},`contact ${Xt(h)}`)},c=(h,f,u,d,g,x)=>p("button",{class:g?"card stale":"card","data-contact-name":h,"aria-pressed":d,onClick:x,title:u,children:[p("span",{class:"soft",children:Xt(h)})," ",p("b",{children:f})," ",p("small",{class:"soft",children:u})]},h);return p("nav",{class:"cards","aria-label":"Contacts with their effective masses",children:[p("span",{class:"soft cards-head",children:["effective mass m̄",p("br",{}),"seen by the"]}),t.map(h=>{let f=h.name===i.contact.at,u=f&&e&&!n?e.report:h.report,d=f&&i.pose.travel?.length;return c(h.name,Ip(u),d?"at the travel shown":yb(h),f,f?!!n:!o,()=>l(h.name))}),a?c(i.contact.at??"own contact",Ip(e?.report),e?`on ${Xt(e.report.contact.link)}`:"",!0,!!n):null,p("button",{class:"card add","aria-pressed":r,onClick:()=>E.set({choosing:!r}),children:r?"click a link … (Esc)":"+ contact: click a link"})]})}var vb=6,bb=4;function Dp(){let{explanation:i,explained:t,study:e,problem:n,posed:s,scene:r}=Zt(),o=!!n||t!==e,a=Yi(()=>Sb(i,o),[i,o]);if(!s||s.report.status!=="finite")return null;let l=i&&Np(i)[0];return p("section",{children:[p("h2",{children:"What changes m̄ most"}),a,r?.sheet?.hardpoints.length?p(Mb,{suggested:l?`${l.point}.${l.axis}`:void 0}):null]})}var Np=i=>i.points.flatMap(t=>(t.per_metre??[]).map((e,n)=>({point:t.point,axis:"xyz"[n],rate:e/1e3}))).sort((t,e)=>Math.abs(e.rate)-Math.abs(t.rate));function Sb(i,t){if(!i)return p("p",{class:"soft",children:i===null?"Sensitivities need a single finite m̄.":t?"Computing …":""});let e=E.posed?.report.unit,n=Np(i).slice(0,vb),s=[...i.links].sort((o,a)=>a.per_kilogram-o.per_kilogram).slice(0,bb),r=Math.max(1e-15,...n.map(({rate:o})=>Math.abs(o)));return p("div",{class:t?"stale":"",children:[n.length?p("table",{class:"shares tornado",children:[p("caption",{children:[e," per +1 mm of a hardpoint, ",E.scene?.sheet?.axes]}),p("colgroup",{children:[p("col",{class:"of-point"}),p("col",{}),p("col",{class:"of-mass"})]}),p("tbody",{children:n.map(({point:o,axis:a,rate:l})=>p("tr",{children:[p("th",{scope:"row",children:p("button",{class:"quiet",title:"Show the hardpoint",onClick:()=>E.set({selected:o,showsPoints:!0}),children:[Xt(o)," ",a]})}),p("td",{class:"bar",children:p("span",{class:l<0?"down":"up",style:{width:`${50*Math.abs(l)/r}%`}})}),p("td",{class:"n",children:[l<0?"−":"+",Jt(Math.abs(l),3)]})]},o+a))})]}):null,p("table",{class:"plain",children:[p("caption",{children:[e," per −1 kg of a link"]}),p("tbody",{children:s.map(o=>p("tr",{children:[p("th",{scope:"row",children:Xt(o.link)}),p("td",{class:"n",children:["−",Jt(o.per_kilogram,3)]})]},o.link))})]})]})}function Mb({suggested:i}){let{posed:t,scene:e,problem:n}=E,[s,r]=le(""),[o,a]=le(""),[l,c]=le("20"),[h,f]=le(""),u=e.sheet,d=o||i||`${u.hardpoints[0].name}.x`,g=Yi(()=>[...u.hardpoints.flatMap(w=>["x","y","z"].map(M=>p("option",{value:`${w.name}.${M}`,children:[Xt(w.name)," ",M]},w.name+M))),...e.links.filter(w=>w.mass>0).map(w=>p("option",{value:`${w.name}.mass`,children:["mass of ",Xt(w.name)]},w.name))],[u.hardpoints.map(w=>w.name).join()]),x=w=>Number(w.replace(",",".")),[m,_]=[x(s),x(l)/1e3],v=async()=>{f("Searching …");let w=await E.solve(d,m,_);if(typeof w=="string")return f(w);let[{coordinate:M,unit:P,old:C,new:y}]=w.coordinates,T=`${Xt(M)} from ${Ot(C,2)} to ${Ot(y,2)} ${P} (${De(y-C,2)})`;f(w.is_reached?`Changed ${T}.`:`Not reached within ${P==="kg"?"half of the mass":`${l} mm`}. Nearest: ${Jt(w.targets[0].reached)} kg with ${T}; nothing was changed.`)};return p("form",{class:"target-search",onSubmit:w=>{w.preventDefault(),v()},children:[p("h3",{children:"Solve for a target"}),p("label",{class:"line",children:[p("span",{children:"m̄, kg"}),p("input",{class:"setting",type:"text",inputMode:"decimal",autocomplete:"off",placeholder:Jt(t.report.effective_mass*.95,4),value:s,onInput:w=>r(w.currentTarget.value)})]}),p("label",{class:"line",children:[p("span",{children:"by changing"}),p("select",{value:d,onChange:w=>a(w.currentTarget.value),children:g})]}),p("label",{class:"line",children:[p("span",{children:"by at most, mm"}),p("input",{class:"setting",type:"text",inputMode:"decimal",autocomplete:"off",value:l,onInput:w=>c(w.currentTarget.value)})]}),p("p",{class:"row",children:p("button",{disabled:!!n||!(m>0)||!(_>0),children:"Solve"})}),h?p("p",{class:"told",role:"status",children:h}):null]})}function Fs({title:i,startsOpen:t=!1,content:e}){let[n,s]=le(t);return p("details",{open:n,onToggle:r=>s(r.currentTarget.open),children:[p("summary",{children:p("h2",{children:i})}),n?e():null]})}var wb=4e3,Op=.02,Tb=1e-9,[$r,$i,ks,Wh,qr]=[340,130,46,8,20];function Up({found:i}){let{answers:t}=E,[e,n]=le(!1),{times:s,force:r,penetration:o}=i,a=t.momentOf(i),l=s.length-1,c=v=>{t.moment=v,E.changed()};Qe(()=>{if(!e)return;let v=0,w=performance.now(),M=P=>{let C=Math.min((P-w)/wb,1)*s[l];c(Math.max(0,s.findLastIndex(y=>y<=C))),C<s[l]?v=requestAnimationFrame(M):n(!1)};return v=requestAnimationFrame(M),()=>cancelAnimationFrame(v)},[e,i]);let h=[...i.bearings].sort((v,w)=>w.peak_force-v.peak_force).filter((v,w,M)=>w===0||Math.abs(v.peak_force-M[w-1].peak_force)>Tb*v.peak_force),f=h.filter(v=>v.peak_force>=Op*i.peak_force),u=[...i.springs,...i.dampers,...i.drives].map(({name:v})=>Xt(v)).join(", "),d=Math.max(i.peak_force,...f.map(v=>v.peak_force))||1,g=v=>ks+v/s[l]*($r-ks-6),x=v=>$i-qr-Math.max(0,v)/d*($i-qr-Wh),m=v=>`M${v.map((w,M)=>`${g(s[M]).toFixed(1)} ${x(w).toFixed(1)}`).join("L")}`,_=`${Ot(s[a]*1e3,2)} ms, contact force ${Jt(r[a],4)} N, compression ${Ot(o[a]*1e3,2)} mm`;return p("div",{class:"moments",children:[p("svg",{viewBox:`0 0 ${$r} ${$i}`,class:"figure",role:"img","aria-label":`Forces over ${Ot(s[l]*1e3,1)} ms; the largest is ${Jt(d,4)} N`,children:[p("path",{d:`M${ks} ${x(d)}H${$r-6}`,class:"grid"}),p("path",{d:`M${ks} ${Wh}V${$i-qr}H${$r-6}`,class:"axis",fill:"none"}),p("text",{x:ks-4,y:x(d)+8,"text-anchor":"end",children:[Jt(d,3)," N"]}),p("text",{x:ks-4,y:$i-qr,"text-anchor":"end",children:"0"}),p("text",{x:$r-6,y:$i-5,"text-anchor":"end",children:[Ot(s[l]*1e3,1)," ms"]}),f.slice(0,3).map(v=>p("path",{d:m(v.force),class:"bearing"},v.name+v.place)),p("path",{d:m(r),class:"contact-force"}),p("path",{d:`M${g(s[a])} ${Wh}V${$i-qr}`,class:"cursor"})]}),p("p",{class:"row player",children:[p("button",{"aria-label":e?"Pause":"Play",onClick:()=>n(!e),children:e?"❚❚":"▶"}),p("input",{type:"range",min:"0",max:l,step:"1",value:a,"aria-label":"time of the impact","aria-valuetext":_,onInput:v=>{n(!1),c(Number(v.currentTarget.value))}})]}),p("p",{class:"told",role:"status","data-force":r[a],children:_}),p("table",{class:"plain",children:[p("caption",{children:"forces in the bearings, N; directions of the arrows as at the touch"}),p("thead",{children:p("tr",{children:[p("th",{children:"bearing"}),p("th",{children:"now"}),p("th",{children:"peak"})]})}),p("tbody",{children:f.map(v=>p("tr",{children:[p("th",{scope:"row",children:Xt(v.name)}),p("td",{class:"n",children:Jt(v.force[a],3)}),p("td",{class:"n",children:Jt(v.peak_force,3)})]},v.name+v.place))})]}),p("p",{class:"soft",children:[u?`Besides the contact, these act: ${u}.`:"The contact force alone acts: neither gravity nor springs.",i.springs_left_out.length?` Left out: ${i.springs_left_out.map(Xt).join(", ")}.`:""]}),h.length>f.length?p("p",{class:"soft",children:[h.length-f.length," further bearings have less than ",Op*100," % of the force of the contact."]}):null]})}var Eb=["mujoco","drake","gazebo","gazebo-classic","ode","bullet","physx","rapier","chrono","adams","simscape","dart","opensim","exudyn","newton","jolt"],Ab=["kelvin-voigt","hunt-crossley"],Cb=["skull","face","neck","back","chest","abdomen","pelvis","upper-arm","lower-arm","hand","thigh","lower-leg"];function Tl({kind:i,title:t,missing:e,children:n,result:s,command:r}){Zt();let{answers:o}=E,a=o.results[i];return p("details",{class:`further ${i}`,open:o.isOpen(i),onToggle:l=>o.fold(i,l.currentTarget.open),children:[p("summary",{children:p("h2",{children:t})}),o.isShown(i)?n:null,o.leftOut[i]?.length?p("p",{class:"soft",children:["Keys of the study that this panel leaves out: ",o.leftOut[i].join(", "),"."]}):null,p("div",{class:E.problem||!o.isFresh()?"stale":"",children:e?p("p",{class:"soft",children:e}):a?"refused"in a?p("p",{class:"box warn",children:a.refused.message}):p(jt,{children:[s(a.ok),p(Rb,{of:a.ok}),p(Pb,{text:r()})]}):o.isShown(i)?p("p",{class:"soft",children:"Computing …"}):null})]})}function Rb({of:i}){let t=new Set(E.findings.map(s=>s.message)),e=[i].flat().flatMap(s=>s.diagnostics??[]),n=new Set(e.filter(s=>s.severity==="warning"&&!t.has(s.message)).map(s=>s.message));return p(jt,{children:[...n].map(s=>p("p",{class:"finding warning",children:s},s))})}function Pb({text:i}){let[t,e]=le("");return p("details",{class:"command",children:[p("summary",{children:"The same as a command"}),p("pre",{class:"text",tabIndex:0,children:i}),p("button",{onClick:async()=>{e(await Xr(i)?"Copied":"Not permitted"),setTimeout(()=>e(""),1500)},children:t||"Copy"})]})}function ni({name:i,label:t,hint:e}){return p("label",{class:"line",children:[p("span",{children:t}),p(bl,{class:"setting",hint:e,value:E.answers.settings[i],set:n=>E.answers.set({[i]:n})})]})}function Ib(i,t){return i.some(e=>(typeof e=="string"?e:e[0])===t)?i:[...i,t]}function wl({name:i,label:t,of:e}){return p("label",{class:"line",children:[p("span",{children:t}),p("select",{value:E.answers.settings[i],onChange:n=>E.answers.set({[i]:n.currentTarget.value}),children:Ib(e,E.answers.settings[i]).map(n=>{let[s,r]=typeof n=="string"?[n,n]:n;return p("option",{value:s,children:r},s)})})]})}function $h({of:i}){return p("table",{class:"plain",children:p("tbody",{children:i.filter(([,t])=>t!==null).map(([t,e])=>p("tr",{children:[p("th",{scope:"row",children:t}),p("td",{class:"n",children:e})]},t))})})}var Ve=(i,t,e)=>i===null?null:`${Jt(i*t,4)} ${e}`,kp={mass:["mass at the stop","kg"],damping:"N·s/m",dissipation:"s/m",force:["peak force","N"],depth:[1e3,"mm"],speed:"m/s",stiffness:"200 N/mm",fast:"1 m/s"},Bp={mass:["inertia at the stop","kg·m²"],damping:"N·m·s/rad",dissipation:"s/rad",force:["peak moment","N·m"],depth:[180/Math.PI,"°"],speed:"rad/s",stiffness:"2000 Nm/rad",fast:"1 rad/s"};function Lb(){return(E.scene?.joints??[]).flatMap(({name:i,kind:t,limits:e})=>{let n=t==="revolute"||t==="continuous";return!e||!(n||t==="prismatic")?[]:["lower","upper"].map((s,r)=>({value:`${i}:${s}`,isTurn:n,label:`${s} stop of ${i}, ${n?`${Ot(e[r]*180/Math.PI,1)}°`:`${Ot(e[r]*1e3,1)} mm`}`}))})}function Db(){let i=Lb();if(!i.length)return null;let{settings:t}=E.answers,e=n=>i.some(s=>s.value===n&&s.isTurn);return p("label",{class:"line",children:[p("span",{children:"contact"}),p("select",{value:t.stop,onChange:n=>{let s=n.currentTarget.value,r=e(s)?Bp:kp;E.answers.set({stop:s,...e(s)===e(t.stop)?{}:{stiffness:r.stiffness,speed:r.fast}})},children:[p("option",{value:"",children:"the contact shown"}),i.map(({value:n,label:s})=>p("option",{value:n,children:s},n))]})]})}function zp(){let{further:i}=E.answers.settings;return p(Tl,{kind:"damper",title:"Damper and simulator",command:()=>mo("damper",E.study,E.answers.settings),result:({exports:t,...e})=>{let n=e.stop?.motion==="turn"?Bp:kp;return p(jt,{children:[p($h,{of:[[n.mass[0],e.stop?Ve(e.effective_mass,1,n.mass[1]):null],["damping c",Ve(e.damping,1,n.damping)],["damping ratio",e.damping_ratio===null?null:Jt(e.damping_ratio,4)],["dissipation d",Ve(e.dissipation,1,n.dissipation)],["restitution of the law",Jt(e.achieved_restitution,4)],[n.force[0],Ve(e.peak_force,1,n.force[1])],["compression",Ve(e.max_penetration,n.depth[0],n.depth[1])],["contact time",Ve(e.contact_duration,1e3,"ms")],["rebound speed",Ve(e.rebound_speed,1,n.speed)],["energy lost",Ve(e.energy_lost,1,"J")]]}),Object.entries(t).map(([s,r])=>p("div",{class:"simulator",children:[p("h3",{children:r.title}),r.error?p("p",{class:"box warn",children:r.error}):null,r.snippet?p("pre",{class:"text",tabIndex:0,"aria-label":`parameters for ${r.title}`,children:r.snippet}):null,r.time_step!==null?p("p",{children:["Time step at most ",Jt(r.time_step*1e3,3)," ms."]}):null,[...r.cannot,...r.missing].map(o=>p("p",{class:"soft",children:o},o)),r.caution?p("p",{class:"soft",children:r.caution}):null]},s))]})},children:[p(Db,{}),p(ni,{name:"restitution",label:"restitution"}),p(ni,{name:"stiffness",label:"stiffness",hint:"200 N/mm"}),p(ni,{name:"speed",label:"speed",hint:"1 m/s"}),p(wl,{name:"law",label:"law",of:Ab}),p(wl,{name:"tool",label:"simulator",of:Eb}),Object.keys(i).length?p("p",{class:"soft",children:["From the study: ",Object.entries(i).map(([t,e])=>`${t} = ${e}`).join(", "),"."]}):null]})}var[Nb,Fp]=[1e-9,.02];function Vp(){return p(Tl,{kind:"impact",title:"Impact",command:()=>mo("impact",E.study,E.answers.settings),result:i=>{let t=a=>a.some(l=>l===null)?null:Math.hypot(...a),e=i.reactions.map(a=>({name:a.name,place:a.place,on:a.on,size:t(a.force),open:a.open_by})).sort((a,l)=>(l.size??1/0)-(a.size??1/0)),n=a=>e.filter(l=>l.size===null||l.size>a*i.impulse),[s,r]=[n(Nb),n(Fp)],o=a=>p("tr",{children:[p("th",{scope:"row",title:a.on??"ground",children:Xt(a.name)}),p("td",{class:"n",children:a.size===null?p("span",{title:`left open by ${a.open.join(", ")}`,children:"not determined"}):Jt(a.size,3)})]},a.place+a.name);return p(jt,{children:[p($h,{of:[["impulse",Ve(i.impulse,1,"N·s")],["energy lost",Ve(i.in_time?.energy.taken_by_contact??i.energy_loss,1,"J")],["mass of a point that sticks",Ve(i.sticking_mass,1,"kg")],["peak force",Ve((i.in_time??i.contact_law)?.peak_force??null,1,"N")],["compression",Ve((i.in_time??i.contact_law)?.max_penetration??null,1e3,"mm")],["contact time",Ve((i.in_time??i.contact_law)?.duration??null,1e3,"ms")],["restitution reached",Ve(i.in_time?.restitution??null,1,"")]]}),i.in_time?p(Up,{found:i.in_time}):p(jt,{children:[p("table",{class:"plain",children:[p("caption",{children:"impulses of joints, N·s; arrows in the view: on the second link"}),p("tbody",{children:r.map(o)})]}),s.length>r.length?p(Fs,{title:`${s.length-r.length} with less than ${100*Fp} %`,content:()=>p("table",{class:"plain",children:p("tbody",{children:s.slice(r.length).map(o)})})}):null,e.length>s.length?p("p",{class:"soft",children:[e.length-s.length," further joints or frames have no impulse."]}):null]})]})},children:[p(ni,{name:"impactRestitution",label:"restitution"}),p(ni,{name:"impactSpeed",label:"speed",hint:"1 m/s"}),p(ni,{name:"impactStiffness",label:"stiffness",hint:E.scene?.sheet?"curve of the sheet, or 200 N/mm":"200 N/mm"}),p("label",{class:"line",children:[p("span",{children:"in time"}),p("input",{type:"checkbox",checked:E.answers.settings.impactInTime!=="",onChange:i=>E.answers.set({impactInTime:i.currentTarget.checked?"yes":""})})]}),p("p",{class:"soft",children:"Before the impact, the mechanism moves with v*, the motion of least energy with this closing speed."})]})}function Gp(){let{answers:i}=E,t={force:"N",pressure:"N/cm2",energy:"J",momentum:"N·s"}[i.settings.limit]??"";return p(Tl,{kind:"safe",title:"Safe speed",missing:i.settings.limitValue.trim()?void 0:"Give the limit of your edition of the standard.",command:()=>mo("safe",E.study,E.answers.settings),result:([e])=>p(jt,{children:[p("p",{class:"speed",children:[p("b",{children:Ot(e.reflected.speed,3)})," m/s ",p("span",{class:"soft",children:["for m̄ ",e.reflected.robot_mass===null?"= ∞":`${Jt(e.reflected.robot_mass,4)} kg`]})]}),p($h,{of:[["for the mass of the standard",`${Ot(e.standard.speed,3)} m/s`],["its mass",Ve(e.standard.robot_mass,1,"kg")],["mass of the body region",Ve(e.region_mass,1,"kg")]]})]}),children:[p(wl,{name:"region",label:"region",of:[["","held, cannot move"],...Cb]}),p(wl,{name:"limit",label:"limit",of:Jl}),p(ni,{name:"limitValue",label:`${i.settings.limit}, ${t}`,hint:"from your standard"}),i.settings.limit==="pressure"?p(ni,{name:"area",label:"area, cm²"}):null,p(ni,{name:"load",label:"load, kg"})]})}var Xh=["camber","toe","caster","kingpin_inclination","scrub_radius","half_track_change","roll_centre_height","camber_gradient","toe_gradient"],Ob={rad:["°",180/Math.PI,3],m:["mm",1e3,2],"rad/m":["°/m",180/Math.PI,2],"N/m":["N/mm",.001,2],N:["N",1,1],kg:["kg",1,3],Hz:["Hz",1,3]};function Hp(){return!E.opened?.scene.sheet||!E.opened.scene.motions.length?null:p(Tl,{kind:"kinematics",title:"Camber, toe, motion ratios",command:()=>md(E.study,E.state()),result:i=>{let t=i.rows[0];if(t?.problem)return p("p",{class:"box warn",children:t.problem});let e=E.variants.at(-1)?.kinematics,n=o=>o.side?`${o.quantity}_${o.side}`:o.quantity,s=i.columns.filter(o=>typeof t?.[n(o)]=="number"),r=o=>{let a=Xh.indexOf(o.quantity);return a>=0?a:o.quantity.includes("motion_ratio")?Xh.length:Xh.length+1};return p("table",{class:"plain",children:[p("thead",{children:p("tr",{children:[p("th",{children:"quantity"}),p("th",{children:"value"}),e?p("th",{children:["Δ ",E.variants.at(-1).name]}):null]})}),p("tbody",{children:[...s].sort((o,a)=>r(o)-r(a)).map(o=>{let[a,l,c]=Ob[o.unit]??["",1,4],h=t[n(o)],f=e?.rows[0]?.[n(o)];return p("tr",{"data-quantity":n(o),"data-value":h,children:[p("th",{scope:"row",children:n(o).replaceAll("_"," ")}),p("td",{class:"n",children:[Ot(h*l,c)," ",a]}),e?p("td",{class:"n soft",children:typeof f=="number"?De((h-f)*l,c):""}):null]},n(o))})})]})},children:p("p",{class:"soft",children:"At the pose shown, from the sheet; every bush is rigid."})})}var Ub=5e-5,Fb=[["+x",[1,0,0]],["−x",[-1,0,0]],["+y",[0,1,0]],["−y",[0,-1,0]],["+z",[0,0,1]],["−z",[0,0,-1]]];function Xp(i){let{scene:t,axes:e}=E,n=t.links.findIndex(a=>a.name===i),s=a=>a.toArray().map((l,c)=>Math.round(l*e[c]*1e7)/1e7+0),r=a=>new R(...a.map((l,c)=>l*e[c]));if(!t.sheet||n<0)return{words:"frame of the link",point:a=>a,toPoint:a=>a,normal:a=>a,toNormal:a=>a};let o=a=>a.toArray().map(l=>Math.round(l*1e7)/1e7+0);return{words:"axes of the sheet, as drawn",point:a=>s(ae(t.design,n,a)),toPoint:a=>o(r(a).applyMatrix4(Mn(t.design,n).invert())),normal:a=>s(Gr(t.design,n,a)),toNormal:a=>o(Us(t.design,n,r(a)))}}function Wp({label:i,link:t,point:e,set:n}){let s=Xp(t),r=s.point(e);return p(jt,{children:[0,1,2].map(o=>p(Ei,{label:`${i} ${"xyz"[o]}, mm, ${s.words}`,value:r[o]*1e3,decimals:1,step:1,title:s.words,set:a=>n(s.toPoint(r.map((l,c)=>c===o?Math.round(a*1e4)/1e7:l)))},o))})}function $p(){let{scene:i,study:t}=Zt();return!i||!t||t.contact.at?null:p("section",{children:[p("h2",{children:"Contact"}),p(kb,{contact:t.contact})]})}function kb({contact:i}){let{scene:t,posed:e}=E,n=t.links.map(x=>x.name),s=(x,m)=>E.setContact({...i,...x},m),r=i.point??[0,0,0],o=i.normal??e?.report.contact.normal_link??[0,0,1],a=i.normal_frame==="world",l=Xp(i.link),c=x=>x.map((m,_)=>m*E.axes[_]+0),h=a?c(o):l.normal(o),f=i.along_line,u=i.against??(i.cable&&f?f.link:""),d=f?i.cable?"cable":i.turning_normal?"turning":"line":"normal",g=x=>{let m={...i};for(let _ of["normal","normal_frame","along_line","turning_normal","cable"])delete m[_];if(x==="normal")E.setContact({...m,normal:e?.report.contact.normal_link??[0,0,1]},"contact along a normal");else{let _=f??Bb(i);E.setContact({...m,along_line:_,...x==="cable"?{cable:!0}:x==="turning"?{turning_normal:!0}:{}},`contact along ${x==="cable"?"a cable":"a line"}`)}};return p(jt,{children:[p("label",{class:"line",children:[p("span",{children:"link"}),p("select",{value:i.link,onChange:x=>s({link:x.currentTarget.value},`contact on ${x.currentTarget.value}`),children:n.map(x=>p("option",{children:x},x))})]}),p("div",{class:"line",children:[p("span",{children:"point, mm"}),p(Wp,{label:"point",link:i.link,point:r,set:x=>s({point:x},"contact point")})]}),p("label",{class:"line",children:[p("span",{children:"direction"}),p("select",{value:d,onChange:x=>g(x.currentTarget.value),children:[p("option",{value:"normal",children:"normal"}),p("option",{value:"line",children:"line to a point, of a stop"}),p("option",{value:"turning",children:"line to a point, of a spring"}),p("option",{value:"cable",children:"cable to a point"})]})]}),f?p(jt,{children:[p("label",{class:"line",children:[p("span",{children:"to link"}),p("select",{value:f.link,onChange:x=>s({along_line:{...f,link:x.currentTarget.value}},"end of the line"),children:n.filter(x=>x!==i.link).map(x=>p("option",{children:x},x))})]}),p("div",{class:"line",children:[p("span",{children:"to point, mm"}),p(Wp,{label:"end of the line",link:f.link,point:f.point,set:x=>s({along_line:{...f,point:x}},"end of the line")})]})]}):p(jt,{children:[p("div",{class:"line",children:[p("span",{children:["normal",t.sheet?"":a?", world":", link"]}),[0,1,2].map(x=>p(Ei,{label:`normal ${"xyz"[x]}`,value:h[x],decimals:3,step:.01,title:t.sheet?`axes of the sheet, ${a?"at the pose shown":"as drawn"}`:void 0,set:m=>{let _=h.map((v,w)=>w===x?m:v);Math.hypot(..._)>0&&s({normal:a?c(_):l.toNormal(_)},"contact normal")}},x))]}),p("div",{class:"line",children:[p("span",{children:"along"}),p("span",{class:"axes",role:"group","aria-label":`Normal along an axis of the ${t.sheet?"sheet":"world"}`,children:Fb.map(([x,m])=>p("button",{"aria-pressed":a&&m.every((_,v)=>_===h[v]),onClick:()=>s({normal:c(m),normal_frame:"world"},`normal ${x}`),children:x},x))})]})]}),p("label",{class:"line",children:[p("span",{children:"against"}),p("select",{value:u,onChange:x=>s({against:x.currentTarget.value||void 0},"other side"),children:[p("option",{value:"",children:"ground"}),n.filter(x=>x!==i.link).map(x=>p("option",{children:x},x))]})]})]})}function Bb(i){let{scene:t,frames:e,posed:n}=E,s=t.links.findIndex(h=>h.name===i.against),r=s>=0?s:t.root,{point_world:o,normal_world:a}=n.report.contact,l=Math.hypot(...o)||1,c=new R(...o).addScaledVector(new R(...a),.3*l).applyMatrix4(Mn(e,r).invert());return{link:t.links[r].name,point:c.toArray().map(h=>Math.round(h*1e3)/1e3+0)}}function zb(){let{study:i,opened:t}=E;if(!t.poses?.length)return null;let{file:e,set:n,travel:s,...r}=i.pose;return p("label",{class:"line",children:[p("span",{children:"pose"}),p("select",{value:e??"",onChange:o=>{let a=o.currentTarget.value;E.change({...i,pose:a?{...r,file:a}:r},a?`pose ${a}`:"design position")},children:[p("option",{value:"",children:"all joints at 0"}),t.poses.map(o=>p("option",{value:o,children:o},o))]})]})}function qh(){let{drivers:i,study:t,scene:e}=Zt();if(!t||!e)return null;let n=e.contacts.find(o=>o.name===t.contact.at),s=i.filter(o=>ac(t,o)!==void 0),r=i[0]?.isMotion?i[0]:void 0;return p("section",{children:[p("h2",{children:"Pose"}),p(zb,{}),i.length?i.map(o=>p(Gb,{driver:o},o.name)):p("p",{class:"soft",children:"No joint with a single position can be set."}),r?p(Vb,{wheels:r,stop:n?.kind==="stop"?n.name.replace(rc,""):void 0}):s.length?p("p",{class:"row",children:p("button",{onClick:()=>E.change({...t,pose:{...t.pose,set:{},travel:[]}},"design position"),children:t.pose.file?`Pose ${t.pose.file}`:"Design position"})}):null]})}function Vb({wheels:i,stop:t}){let{study:e,contacts:n}=E,s=E.positionOf(i),r=[{name:"design position",travel:0},...Xs(n)].sort((o,a)=>o.travel-a.travel);return p("p",{class:"row",children:r.map(({name:o,travel:a})=>{let l=o===t?{...e,pose:{...e.pose,travel:[]}}:on(e,i,a);return p("button",{"aria-pressed":Math.abs(s-a)<Ub,onClick:()=>E.change(l,o==="design position"?o:`touch of the ${Xt(o)}`),children:[Xt(o)," ",De(a*1e3,1)]},o)})})}function Gb({driver:i}){let{study:t}=E,{unit:e}=i,n=E.positionOf(i),s=o=>E.change(on(t,i,o),i.label),r=n*e.perSi;return p("div",{class:"driver",children:[p("span",{class:"name",title:i.label,children:i.label}),p(Mp,{label:i.label,value:r,range:[i.range[0]*e.perSi,i.range[1]*e.perSi],step:e.step,text:`${Ot(r,1)} ${e.name}`,set:o=>s(o/e.perSi)}),p(Ei,{label:`${i.label}, ${e.name}`,value:r,decimals:e.decimals,step:e.step,set:o=>s(o/e.perSi)}),p("span",{class:"unit",children:e.name})]})}var qp=5e-4;function Yp(){let{posed:i,problem:t}=Zt();if(!i)return null;let{report:e}=i,n=[...e.bodies.map(o=>({name:o.link,share:o.share??0})),...e.rotors.map(o=>({name:`rotor of ${o.joint}`,share:o.share??0}))].sort((o,a)=>a.share-o.share),s=n.filter(o=>o.share>=qp),r=Math.max(1e-12,s[0]?.share??0);return e.status!=="finite"?null:p("section",{class:t?"stale":"",children:[p("h2",{children:"Contributions to m̄"}),p("table",{class:"shares",children:[p("colgroup",{children:[p("col",{class:"of-name"}),p("col",{}),p("col",{class:"of-share"}),p("col",{class:"of-mass"})]}),p("tbody",{children:s.map(({name:o,share:a})=>p("tr",{children:[p("th",{scope:"row",title:o,children:Xt(o)}),p("td",{class:"bar",children:p("span",{style:{width:`${100*a/r}%`,background:`#${Xi(a/r).getHexString()}`}})}),p("td",{class:"n",children:[Ot(100*a,1)," %"]}),p("td",{class:"n soft",children:[Jt(a*e.effective_mass,3)," ",e.unit]})]},o))})]}),s.length<n.length?p("p",{class:"soft",children:[n.length-s.length," further links or frames: less than ",qp*100," % each."]}):null]})}function Zp(){let{scene:i,selected:t}=Zt(),e=i?.sheet;if(!e?.hardpoints.length)return null;let n=Object.keys(E.study?.model.move??{}).length,s={m:4,cm:2,mm:1,in:3}[e.unit]??3,r={m:.001,cm:.1,mm:1,in:.05}[e.unit]??.001;return p(Fs,{title:`Hardpoints, ${e.unit}`,startsOpen:!0,content:()=>p(jt,{children:[p("p",{class:"soft",children:["Drag in the view, or type; arrow keys move by ",r," ",e.unit,". ",e.axes,"."]}),p("table",{class:"points",children:[p("thead",{children:p("tr",{children:[p("th",{children:"name"}),p("th",{children:"x"}),p("th",{children:"y"}),p("th",{children:"z"})]})}),p("tbody",{children:e.hardpoints.map(({name:o})=>p(Hb,{name:o,isSelected:o===t,decimals:s,step:r},o))})]}),n?p("p",{class:"row",children:p("button",{onClick:()=>{let{move:o,...a}=E.study.model;E.change({...E.study,model:a},"all hardpoints back")},children:["All hardpoints back (",n," moved)"]})}):null]})})}function Hb({name:i,isSelected:t,decimals:e,step:n}){let s=E.opened.scene.sheet,r=E.moved(i),{coordinates:o}=s.hardpoints.find(a=>a.name===i);return Yi(()=>{let a=Wb(i);return p("tr",{class:t?"selected":"",onClick:()=>E.set({selected:i}),children:[p("th",{scope:"row",title:r.some(l=>l!==0)?`Δ ${r.map(l=>De(l*1e3,1)).join(", ")} mm`:i,children:i}),[0,1,2].map(l=>{let c=o[l]-a[l];return p("td",{children:p(Ei,{label:`${i} ${"xyz"[l]}, ${s.unit}`,value:(c+r[l])/s.unit_length,decimals:e,step:n,changed:r[l]!==0,title:r[l]!==0?`moved by ${De(r[l]*1e3,1)} mm`:void 0,set:h=>{let f=[...E.moved(i)];f[l]=h*s.unit_length-c,E.movePoint(i,f,`${i} ${"xyz"[l]}`)}})},l)})]})},[i,t,o,...r])}function Wb(i){return E.movedAtOpening[i]??[0,0,0]}function Xb(i){return i>=10?["kg·m²",1]:i>=.001?["kg·cm²",1e4]:["kg·mm²",1e6]}function Kp(){let{scene:i,study:t}=Zt();if(!i||!t)return null;let e=t.model.link_mass??{},n=E.opened.scene.links.filter(f=>f.mass>0||e[f.name]!==void 0);if(!n.length)return null;let s=(f,u)=>{let d={...e,[f]:Math.max(0,Math.round(u*1e6)/1e6)};E.change({...t,model:{...t.model,link_mass:d}},`mass of ${f}`)},r=t.model.link_inertia??{},o=(f,u)=>{let d={...r,[f]:u};E.change({...t,model:{...t.model,link_inertia:d}},`moments of inertia of ${f}`)},a=f=>{let{link_mass:u,link_inertia:d,...g}=t.model,x=w=>Object.fromEntries(Object.entries(w??{}).filter(([M])=>M!==f)),[m,_]=[x(u),x(d)],v={...g,...Object.keys(m).length?{link_mass:m}:{},...Object.keys(_).length?{link_inertia:_}:{}};E.change({...t,model:v},`${f} as in the file`)},l=f=>r[f]??i.links.find(u=>u.name===f)?.moments,[c,h]=Xb(Math.max(0,...E.opened.scene.links.flatMap(f=>f.moments??[])));return p(Fs,{title:"Masses and moments of inertia",startsOpen:!i.sheet?.hardpoints.length,content:()=>p(jt,{children:[p("table",{class:"points inertias",children:[p("thead",{children:p("tr",{children:[p("th",{}),p("th",{children:"kg"}),["xx","yy","zz"].map(f=>p("th",{children:["I",p("sub",{children:f}),", ",c]},f))]})}),p("tbody",{children:n.map(f=>{let{name:u}=f,d=l(u),g=e[u]!==void 0||r[u]!==void 0;return p("tr",{children:[p("th",{scope:"row",title:u,children:[g?p("button",{class:"quiet",onClick:()=>a(u),title:"as in the file","aria-label":`mass and inertia of ${u} as in the file`,children:"↺"}):null,u]}),p("td",{children:p(Ei,{label:`mass of ${u}, kg`,value:e[u]??f.mass,decimals:3,step:.1,changed:e[u]!==void 0,set:x=>s(u,x)})}),d?d.map((x,m)=>{let _=x*h,v=_>0?Math.min(5,Math.max(0,2-Math.floor(Math.log10(_)))):2;return p("td",{children:p(Ei,{label:`${"xyz"[m]} moment of inertia of ${u}, ${c}`,value:_,decimals:v,step:10**(1-v),changed:r[u]!==void 0,set:w=>o(u,d.map((M,P)=>Number((P===m?Math.max(0,w)/h:M).toPrecision(9))))})},m)}):p("td",{colSpan:3})]},u)})})]}),p("p",{class:"soft",children:"Moments about the centre of mass, along the axes of the link. A changed mass scales them in proportion, unless they are changed too."})]})})}function Yh(){let{posed:i,problem:t}=Zt(),e=i?.report.motion_ratios??[];return e.length?p("section",{class:t?"stale":"",children:[p("h2",{children:"Motion ratios"}),p("table",{class:"plain",children:p("tbody",{children:e.map(n=>p("tr",{children:[p("th",{scope:"row",children:Xt(n.link)}),p("td",{class:"n",children:n.contact_per_wheel===null?"infinite":Ot(n.contact_per_wheel,4)})]},n.link))})}),p("p",{class:"soft",children:["Closing of the contact per upward travel of the point",e.some(n=>!n.one_travel)?", in the motion of the impact":"","."]})]}):null}function Jp(){let{findings:i}=Zt(),[t,e]=le(!1),n=i.filter(r=>r.severity!=="note");return i.length?p("section",{children:[p("h2",{children:"Findings"}),(t?i:n).map((r,o)=>p("p",{class:`finding ${r.severity}`,children:[r.severity==="note"?"":`${r.severity}: `,r.line?`line ${r.line}: `:"",r.message]},o)),i.length>n.length?p("button",{class:"quiet","aria-expanded":t,onClick:()=>e(!t),children:t?"Fewer":`${i.length-n.length} ${i.length-n.length===1?"note":"notes"}`}):null]}):null}function jp(){let{curve:i,driver:t,posed:e}=Zt();return!t||!i||!("ok"in i)?null:p(Fs,{title:"Curve as a table",content:()=>p("table",{class:"plain curve-table",children:[p("thead",{children:p("tr",{children:[p("th",{children:[t.label,", ",t.unit.name]}),p("th",{children:["m̄, ",e?.report.unit??"kg"]})]})}),p("tbody",{children:i.ok.rows.map((n,s)=>p("tr",{children:[p("td",{class:"n",children:Ot(n.at*t.unit.perSi,2)}),p("td",{class:"n",title:n.why??"",children:n.mass===null?n.status:Jt(n.mass,6)})]},s))})]})})}var $b=3,qb="(max-width: 760px)";function Qp(){let{scene:i,drivers:t,answers:e}=Zt(),n=sn(null);Qe(()=>{let u=n.current.parentElement,d=u.querySelector(".result"),g=new ResizeObserver(()=>u.style.setProperty("--under-result",`${d.offsetHeight}px`));return g.observe(d),()=>g.disconnect()},[]);let s=!!i.sheet,r=s&&i.motions.length>0,o=t.length<=$b,l=[["result","Result",()=>p(jt,{children:[p(Yp,{}),p($p,{}),o?null:p(qh,{}),r?null:p(Yh,{}),p(Dp,{})]})],["design","Design",()=>p(jt,{children:[p(Yb,{}),p(Zp,{}),p(Kp,{})]})],["kinematics","Kinematics",()=>p(jt,{children:[p(Yh,{}),p(Hp,{})]})],["safe","Safe speed",()=>p(Gp,{})],["impact","Impact & damper",()=>p(jt,{children:[p(Vp,{}),p(zp,{})]})]].filter(([u])=>(u!=="kinematics"||r)&&(u!=="safe"||!s)),c=l.some(([u])=>u===e.tab)?e.tab:"result",h=u=>{e.turnTo(u),Ji(E.linked()).then(d=>history.replaceState(null,"",d)),matchMedia(qb).matches&&requestAnimationFrame(()=>document.getElementById(`answer-${u}`).scrollIntoView())};return p(jt,{children:[o?p(qh,{}):null,p("div",{ref:n,class:"answers",role:"tablist","aria-label":"Answers",onKeyDown:u=>{let d=l.findIndex(([m])=>m===c),g={ArrowRight:d+1,ArrowLeft:d-1,Home:0,End:l.length-1}[u.key];if(g===void 0)return;u.preventDefault();let[x]=l[(g+l.length)%l.length];h(x),document.getElementById(`tab-${x}`).focus()},children:l.map(([u,d])=>p("button",{id:`tab-${u}`,role:"tab","aria-selected":u===c,"aria-controls":`answer-${u}`,tabIndex:u===c?0:-1,onClick:()=>h(u),children:d},u))}),l.map(([u,,d])=>p("div",{id:`answer-${u}`,class:"answer",role:"tabpanel","aria-labelledby":`tab-${u}`,hidden:u!==c,children:d()},u))]})}function Yb(){let{study:i,scene:t}=Zt(),{move:e,link_mass:n,link_inertia:s}=i.model,r=[e,n,s].reduce((o,a)=>o+Object.keys(a??{}).length,0);return!t.sheet?.hardpoints.length||!r?null:p("p",{class:"row",children:p("button",{onClick:Hh,children:["Save the sheet (",r," ",r===1?"change":"changes",")"]})})}function tm(){let{variants:i,posed:t,problem:e}=Zt();if(!i.length||!t)return null;let{effective_mass:n,unit:s}=t.report;return p("section",{class:e?"stale":"",children:[p("h2",{children:"Variants"}),p("table",{class:"plain",children:[p("thead",{children:p("tr",{children:[p("th",{children:"design"}),p("th",{children:["m̄, ",s]}),p("th",{colSpan:2,children:["now − it, ",s]})]})}),p("tbody",{children:i.map(r=>{let o=n!==null&&r.mass!==null?n-r.mass:void 0;return p("tr",{class:"variant",children:[p("th",{scope:"row",children:[p("button",{title:`Back to variant ${r.name}`,onClick:()=>E.change(r.study,`variant ${r.name}`),style:{color:Wi[r.colour]},children:r.name}),p("button",{class:"quiet","aria-label":`Remove variant ${r.name}`,onClick:()=>E.set({variants:i.filter(a=>a!==r)}),children:"×"})]}),p("td",{class:"n",children:r.mass===null?"–":Jt(r.mass)}),p("td",{class:"n difference",children:o===void 0?"–":De(o,Math.max(0,3-Math.floor(Math.log10(Math.max(n,1e-9)))))}),p("td",{class:"n soft",children:o===void 0?"":`${o>0?"+":""}${Ot(100*o/r.mass,2)} %`})]},r.name)})})]})]})}var Zb=.45,em=.3,Kb=.001,nm=400,im=.02,Jb=100;function sm(i){let t=E.answers.results.impact;if(!E.answers.isShown("impact")||!t||!("ok"in t)||!E.answers.isFresh())return[];let{reactions:e,impulse:n,in_time:s}=t.ok,r=s?E.answers.momentOf(s):0,o=u=>u.force.reduce((d,g,x)=>d.addScaledVector(new R(...u.axes_world[x]),g??0),new R),a=e.flatMap(u=>{let d=s?.bearings.find(x=>x.name===u.name&&x.place===u.place);if(s&&!d)return[];let g=o(u);return[{at:new R(...u.point_world),by:d?g.normalize():g,size:d?.force[r]??g.length(),most:d?.peak_force??g.length(),name:u.name,on:u.on??"ground"}]}),{point_world:l,normal_world:c,link:h}=E.posed.report.contact;a.push({at:new R(...l),by:new R(...c).negate(),size:s?.force[r]??n,most:s?.peak_force??n,name:"contact",on:h});let f=Math.max(1e-12,...a.map(({most:u})=>u));return a.filter(({size:u})=>u>Kb*f).map(({at:u,by:d,size:g,name:x,on:m})=>({at:u,by:d.clone().setLength(Zb*i*g/f),title:`${x}: ${g.toPrecision(3)} ${s?"N":"N·s"} on ${m}`}))}function rm(i){let t=E.answers.results.directions;if(!E.answers.isShown("directions")||!t||!("ok"in t)||!E.answers.isFresh())return[];let{principal:e}=t.ok,n=Math.min(...e.map(o=>o.effective_mass??1/0)),s=Math.max(0,...e.map(o=>o.effective_mass??0)),r=em*i/Math.sqrt(Math.min(s,nm*n)||1);return e.map(o=>{let a=o.effective_mass,l=a!==null&&a<=nm*n,c=o.status==="massless"?0:l?r*Math.sqrt(a):1.3*em*i,h=a===null?o.status==="immovable"?"∞":"0 kg":`${a.toPrecision(4)} kg`;return{half:new R(...o.direction_world).multiplyScalar(c),label:h,isBounded:l||o.status==="massless"}})}function Zh(i){let t=[...i.values()].flat().map(n=>n.effective_mass).filter(n=>n!==null&&n>0).sort((n,s)=>n-s);if(!t.length)return;let e=t[Math.floor(im*(t.length-1))];return[e,Math.min(t[Math.ceil((1-im)*(t.length-1))],Jb*e)]}function om(i){let t=Zh(i),e=({status:n,effective_mass:s})=>s===null||!t?n==="massless"?Xi(0):new kt("#6b7785"):Xi(Math.log(s/t[0])/Math.max(1e-9,Math.log(t[1]/t[0])));return new Map([...i].map(([n,s])=>[n,s.map(e)]))}var Jh=new R(0,1,0),Yr="#8793a1",jb="#4b5563",Qb=.016,tS=.008,eS=.022;function am(i,t,e){let n=t.clone().sub(i),s=n.length(),r=new Ue().setFromUnitVectors(Jh,s>0?n.divideScalar(s):Jh);return new Qt().compose(i.clone().add(t).multiplyScalar(.5),r,new R(e,Math.max(s,1e-9),e))}function nS(){let[i,t,e]=[7,112,9],n=Array.from({length:t+1},(s,r)=>{let o=2*Math.PI*i*r/t;return new R(Math.cos(o),e*(r/t-.5),Math.sin(o))});return new yr(new Ts(n),240,.17,7).scale(1,1/e,1)}function iS(){let t=[[.64,-.24],[.93,-.3],[.985,-.24],[1,0],[.985,.24],[.93,.3],[.64,.24],[.64,-.24]],e=(r,o,a)=>new R(r*Math.cos(a),o,r*Math.sin(a)),n=(r,o)=>Array.from({length:49},(a,l)=>e(r,o,l*Math.PI/24)),s=r=>t.map(([o,a])=>e(o,a,r));return[n(.94,-.3),n(.94,.3),...[0,1,2,3].map(r=>s(r*Math.PI/2))]}var lm=new ws(1,1,1,14),Kh=new xr(1,14,10),sS=new ws(.25,1,1.6,4),rS=nS(),oS=iS(),cm=new xi({color:jb}),aS=new xi({color:Yr}),lS=new xi({vertexColors:!0,side:pn}),cS=new _i({color:"#9aa5b1"}),hS=Wi.map(i=>new _i({color:i})),El=class{constructor(t,e,n,s){this.scene=t;this.radius=n;let r=s?.scene.links.length===t.links.length?s.materials.splice(0):[];t.links.forEach((o,a)=>{let l=new Fn;l.matrixAutoUpdate=!1;let c=r[a]??new xi({color:Yr,side:pn}),h=e[a];if(h&&h.length){let f=this.keep(new $e);f.setAttribute("position",new un(h,3)),f.computeVertexNormals(),this.addLink(l,new ze(f,c),a)}else{let f=this.radius*(o.mass>0?Qb:tS),u=[];if(!o.lines.length&&o.mass>0&&o.com){let d=new ze(Kh,c);d.position.set(...o.com),d.scale.setScalar(3*f),this.addLink(l,d,a)}for(let d of o.lines){if(this.endsAtPatch(a,d))continue;let[g,x]=d.map(_=>new R(..._)),m=new ze(lm,c);m.matrixAutoUpdate=!1,m.matrix.copy(am(g,x,f)),this.addLink(l,m,a);for(let _ of[g,x]){if(u.some(w=>w.distanceTo(_)<.001*this.radius))continue;u.push(_);let v=new ze(Kh,c);v.position.copy(_),v.scale.setScalar(f),this.addLink(l,v,a)}}}this.materials.push(c),this.links.push(l),this.group.add(l)}),this.addJoints();for(let o of t.contacts){let a={spring:1,damper:2,stop:2,patch:0,other:0}[o.kind],l=o.kind==="spring"?rS:lm,c=Array.from({length:a},()=>new ze(l,o.kind==="stop"?cm:aS));for(let h of c)h.matrixAutoUpdate=!1,this.group.add(h);this.elements.push({contact:o,meshes:c})}}scene;radius;group=new Fn;links=[];pickable=[];materials=[];elements=[];ghosts=[];own=[];endsAtPatch(t,e){return this.scene.links.some(({name:n},s)=>n.startsWith("contact_patch")&&e.some(r=>ae(this.scene.design,t,r).distanceTo(ae(this.scene.design,s,[0,0,0]))<1e-4*this.radius))}keep(t){return this.own.push(t),t}addLink(t,e,n){e.userData.link=n,t.add(e),this.pickable.push(e)}addJoints(){let t=(n,s,r)=>{let o=new ze(r?sS:Kh,cm);o.position.set(...s),o.scale.setScalar(this.radius*eS*(r?1.2:.85)),r&&(o.rotation.x=Math.PI/2),this.links[n].add(o)},e=new Set;for(let n of this.scene.joints){if(n.kind==="fixed")continue;let s=ae(this.scene.design,n.child,[0,0,0]),r=s.toArray().map(o=>o.toFixed(4)).join();if(!e.has(r))if(e.add(r),n.parent===this.scene.root){let o=s.clone().applyMatrix4(Mn(this.scene.design,this.scene.root).invert());t(this.scene.root,o.toArray(),!0)}else t(n.child,[0,0,0],!1)}for(let{ends:n}of this.scene.closures)for(let[s,r]of n)s!==null&&s!==this.scene.root&&t(s,r,!1)}wires(t,e,n){let s=u=>e?.[u]?`#${e[u].getHexString()}`:Yr,{links:r,wheels:o,contacts:a,root:l}=this.scene,c=o.flatMap(u=>{let d=new Ue().setFromUnitVectors(Jh,new R(...u.axis).normalize()),g=new Qt().compose(new R(...u.centre),d,new R().setScalar(u.radius)).premultiply(Mn(t,u.link)),x=r[u.link].name.replace("wheel_centre","wheel");return oS.map(m=>({points:m.map(_=>_.clone().applyMatrix4(g)),colour:s(r.findIndex(_=>_.name===x)),isThin:!0}))});if(!n)return c;let h=r.flatMap((u,d)=>u.lines.filter(g=>!this.endsAtPatch(d,g)).map(g=>({points:g.map(x=>ae(t,d,x)),colour:s(d),isThin:!1}))),f=a.filter(({kind:u})=>u==="spring"||u==="damper"||u==="stop").map(u=>{let[d,g]=[ae(t,u.link,u.point),u.against??l],x=u.normal==="fixed"?d.clone().addScaledVector(Gr(t,g,u.vector),u.gap??0):ae(t,g,u.vector);return{points:[d,x],colour:Yr,isThin:!0}});return[...h,...c,...f]}pose(t){this.links.forEach((e,n)=>{e.matrix.copy(Mn(t,n)),e.matrixWorldNeedsUpdate=!0});for(let{contact:e,meshes:n}of this.elements){let s=ae(t,e.link,e.point),r=e.against??this.scene.root,a=e.normal!=="fixed"?ae(t,r,e.vector):void 0,l=a?a.clone().sub(s):Gr(t,r,e.vector),c=l.length();l.normalize(),e.normal==="away"&&l.negate();let h=(f,u,d,g)=>n[g]?.matrix.copy(am(s.clone().addScaledVector(l,f),s.clone().addScaledVector(l,u),d*this.radius));if(e.kind==="spring"&&h(0,c,.042,0),e.kind==="damper"&&(h(0,c,.007,0),h(0,.55*c,.02,1)),e.kind==="stop"){let f=.02*this.radius,u=Math.max(a?c:e.gap??0,0);h(-f,0,.026,0),h(u,u+.35*f,.04,1),e.normal==="away"&&(n[1].visible=!1)}}}colour(t,e){this.materials.forEach((n,s)=>{n.color.copy(t?.[s]??new kt(Yr)),n.emissive.set(s===e?"#12304a":"#000000")})}paint(t){for(let e of this.pickable){let n=t?.get(e.userData.link),s=this.materials[e.userData.link];if(!n){e.material=s;continue}let r=new Float32Array(9*n.length);n.forEach((o,a)=>{for(let l=0;l<3;l++)o.toArray(r,9*a+3*l)}),e.geometry.setAttribute("color",new un(r,3)),e.material=lS}}outline(t,e,n){let s=t.links.flatMap((r,o)=>r.lines.filter(a=>!this.endsAtPatch(o,a)).flatMap(a=>a.map(l=>ae(e,o,l))));return new Ss(new $e().setFromPoints(s),n)}outlines(t,e){for(let n of this.ghosts)this.group.remove(n),n.geometry.dispose();this.ghosts=e.map(n=>this.outline(n.scene,n.frames,hS[n.colour])),t&&this.ghosts.push(this.outline(this.scene,this.scene.design,cS)),this.ghosts.length&&this.group.add(...this.ghosts)}dispose(){for(let t of this.own)t.dispose();for(let t of this.materials)t.dispose();this.outlines(!1,[])}};var hm={type:"change"},Qh={type:"start"},dm={type:"end"},Al=new mi,um=new hn,uS=Math.cos(70*Th.DEG2RAD),Re=new R,nn=2*Math.PI,ne={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},jh=1e-6,Cl=class extends Cr{constructor(t,e=null){super(t,e),this.state=ne.NONE,this.target=new R,this.cursor=new R,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Si.ROTATE,MIDDLE:Si.DOLLY,RIGHT:Si.PAN},this.touches={ONE:Mi.ROTATE,TWO:Mi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new R,this._lastQuaternion=new Ue,this._lastTargetPosition=new R,this._quat=new Ue().setFromUnitVectors(t.up,new R(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Cs,this._sphericalDelta=new Cs,this._scale=1,this._panOffset=new R,this._rotateStart=new Mt,this._rotateEnd=new Mt,this._rotateDelta=new Mt,this._panStart=new Mt,this._panEnd=new Mt,this._panDelta=new Mt,this._dollyStart=new Mt,this._dollyEnd=new Mt,this._dollyDelta=new Mt,this._dollyDirection=new R,this._mouse=new Mt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=fS.bind(this),this._onPointerDown=dS.bind(this),this._onPointerUp=pS.bind(this),this._onContextMenu=bS.bind(this),this._onMouseWheel=_S.bind(this),this._onKeyDown=xS.bind(this),this._onTouchStart=yS.bind(this),this._onTouchMove=vS.bind(this),this._onMouseDown=mS.bind(this),this._onMouseMove=gS.bind(this),this._interceptControlDown=SS.bind(this),this._interceptControlUp=MS.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ne.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(hm),this.update(),this.state=ne.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Re.copy(e).sub(this.target),Re.applyQuaternion(this._quat),this._spherical.setFromVector3(Re),this.autoRotate&&this.state===ne.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=nn:n>Math.PI&&(n-=nn),s<-Math.PI?s+=nn:s>Math.PI&&(s-=nn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Re.setFromSpherical(this._spherical),Re.applyQuaternion(this._quatInverse),e.copy(this.target).add(Re),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Re.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new R(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new R(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Re.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Al.origin.copy(this.object.position),Al.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Al.direction))<uS?this.object.lookAt(this.target):(um.setFromNormalAndCoplanarPoint(this.object.up,this.target),Al.intersectPlane(um,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>jh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>jh||this._lastTargetPosition.distanceToSquared(this.target)>jh?(this.dispatchEvent(hm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?nn/60*this.autoRotateSpeed*t:nn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Re.setFromMatrixColumn(e,0),Re.multiplyScalar(-t),this._panOffset.add(Re)}_panUp(t,e){this.screenSpacePanning===!0?Re.setFromMatrixColumn(e,1):(Re.setFromMatrixColumn(e,0),Re.crossVectors(this.object.up,Re)),Re.multiplyScalar(t),this._panOffset.add(Re)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Re.copy(s).sub(this.target);let r=Re.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(nn*this._rotateDelta.x/e.clientHeight),this._rotateUp(nn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(nn*this._rotateDelta.x/e.clientHeight),this._rotateUp(nn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Mt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function dS(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function fS(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function pS(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(dm),this.state=ne.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function mS(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Si.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=ne.DOLLY;break;case Si.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=ne.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=ne.ROTATE}break;case Si.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=ne.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=ne.PAN}break;default:this.state=ne.NONE}this.state!==ne.NONE&&this.dispatchEvent(Qh)}function gS(i){switch(this.state){case ne.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case ne.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case ne.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function _S(i){this.enabled===!1||this.enableZoom===!1||this.state!==ne.NONE||(i.preventDefault(),this.dispatchEvent(Qh),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(dm))}function xS(i){this.enabled!==!1&&this._handleKeyDown(i)}function yS(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Mi.ROTATE:if(this.enableRotate===!1){this.state=ne.NONE;break}this._handleTouchStartRotate(i),this.state=ne.TOUCH_ROTATE;break;case Mi.PAN:if(this.enablePan===!1){this.state=ne.NONE;break}this._handleTouchStartPan(i),this.state=ne.TOUCH_PAN;break;default:this.state=ne.NONE}break;case 2:switch(this.touches.TWO){case Mi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=ne.TOUCH_DOLLY_PAN;break;case Mi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=ne.TOUCH_DOLLY_ROTATE;break;default:this.state=ne.NONE}break;default:this.state=ne.NONE}this.state!==ne.NONE&&this.dispatchEvent(Qh)}function vS(i){switch(this._trackPointer(i),this.state){case ne.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case ne.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case ne.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case ne.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=ne.NONE}}function bS(i){this.enabled!==!1&&i.preventDefault()}function SS(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function MS(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var wS={"3d":{from:new R(.78,.86,.52),up:new R(0,0,1)},front:{from:new R(1,0,0),up:new R(0,0,1)},side:{from:new R(0,1,0),up:new R(0,0,1)},top:{from:new R(0,0,1),up:new R(1,0,0)}},tu=32,TS=.78,ES=.7,AS=420,CS=6,eu=.5,Rl=class{perspective=new Ze(tu,1,.01,100);flat=new ki(-1,1,1,-1,-100,100);controls;name="3d";centre=new R;radius=1;points=[];size=[1,1];constructor(t,e){let n=(s,r)=>{let o=new Cl(s,t);return o.enableRotate=r,o.enableDamping=!1,o.zoomToCursor=!0,r||(o.mouseButtons.LEFT=2),r||(o.touches.ONE=1),o.addEventListener("change",e),o};this.perspective.up.set(0,0,1),this.controls={perspective:n(this.perspective,!0),flat:n(this.flat,!1)},this.controls.flat.enabled=!1}get camera(){return this.name==="3d"?this.perspective:this.flat}enable(t){this.controls.perspective.enabled=t&&this.name==="3d",this.controls.flat.enabled=t&&this.name!=="3d"}resize(t,e){this.size=[t,e],this.perspective.aspect=t/e,this.perspective.updateProjectionMatrix();let n=this.radius;Object.assign(this.flat,{left:-n*t/e,right:n*t/e,top:n,bottom:-n}),this.flat.updateProjectionMatrix()}fit(t){this.points=t;let e=t.reduce((s,r)=>s.clone().min(r),t[0]),n=t.reduce((s,r)=>s.clone().max(r),t[0]);this.centre=e.clone().add(n).multiplyScalar(.5),this.radius=n.distanceTo(e)/2||eu,this.show(this.name)}show(t){this.name=t;let{from:e,up:n}=wS[t],s=this.camera,r=t==="3d"?this.controls.perspective:this.controls.flat,o=e.clone().normalize();this.resize(...this.size),s.up.copy(n),this.flat.zoom=1,this.flat.near=-20*this.radius,this.flat.far=20*this.radius,this.perspective.near=this.radius/50,this.perspective.far=this.radius*200,this.flat.updateProjectionMatrix(),this.perspective.updateProjectionMatrix();let a=this.radius/Math.tan(tu/2*(Math.PI/180)),l=this.centre.clone();for(let c=0;c<CS;c++){s.position.copy(l).addScaledVector(o,a),s.lookAt(l),s.updateMatrixWorld();let h=this.points.map(v=>v.clone().project(s)),[f,u]=[Math.min(...h.map(v=>v.x)),Math.max(...h.map(v=>v.x))],[d,g]=[Math.min(...h.map(v=>v.y)),Math.max(...h.map(v=>v.y))];if(u===f&&g===d)break;let x=Math.max(u-f,g-d)/2/(this.size[1]<AS?ES:TS),m=l.clone().project(s).z,_=new R((f+u)/2,(d+g)/2,m).unproject(s);l.copy(_),t==="3d"?a*=x:this.flat.zoom/=Math.max(x,1e-9),this.flat.updateProjectionMatrix()}s.position.copy(l).addScaledVector(o,a),s.lookAt(l),s.updateMatrixWorld(),r.target.copy(l),r.object=s,this.enable(!0),r.update()}pixel(t){if(this.name!=="3d")return(this.flat.top-this.flat.bottom)/this.flat.zoom/this.size[1];let e=t.clone().sub(this.perspective.position).dot(this.perspective.getWorldDirection(new R));return 2*Math.abs(e)*Math.tan(tu/2*(Math.PI/180))/this.size[1]}project(t){let e=t.clone().project(this.camera),[n,s]=this.size;return{x:(e.x+1)/2*n,y:(1-e.y)/2*s,visible:e.z>-1&&e.z<1}}ray(t,e){let[n,s]=this.size,[r,o]=[2*t/n-1,1-2*e/s],a=new R(r,o,-1).unproject(this.camera),l=new R(r,o,1).unproject(this.camera);return{origin:a,direction:l.sub(a).normalize()}}inPlane(t,e,n){let{origin:s,direction:r}=this.ray(t,e),o=this.camera.getWorldDirection(new R),a=n.clone().sub(s).dot(o)/r.dot(o);return s.addScaledVector(r,a)}};var RS="http://www.w3.org/2000/svg";function ue(i,t,e){let n=document.createElementNS(RS,i);for(let[s,r]of Object.entries(t))n.setAttribute(s,String(r));return e?.append(n),n}function nu(i,t,e){for(;i.children.length>e;)i.lastChild.remove();for(;i.children.length<e;)ue(t,{},i);return[...i.children]}var PS=600,IS=48,fm=10,pm=15,LS=[[1,0],[-1,0],[1,-1],[1,1],[-1,-1],[-1,1]],DS=74,NS=15,mm=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10],Pl=class{svg;wires;points;motion;directions;impulses;contact;label;names;axes;scale;width=1;height=1;bottom=1;drawnAxes="";constructor(t){this.svg=ue("svg",{class:"overlay","aria-hidden":"true"}),t.append(this.svg);let e=n=>ue("g",{class:n},this.svg);this.wires=e("wires"),this.motion=e("motion"),this.directions=e("directions"),this.impulses=e("impulses"),this.points=e("points"),this.names=e("names"),this.contact=e("contact"),this.label=e("label"),this.axes=e("axes"),this.scale=e("scale")}resize(t,e){this.width=t,this.height=e,this.svg.setAttribute("viewBox",`0 0 ${t} ${e}`),this.bottom=e-(t<PS?IS:0)}drawWires(t,e){let n=nu(this.wires,"path",e.length);e.forEach(({points:s,colour:r,isThin:o},a)=>{let l=s.map(c=>{let{x:h,y:f}=t.project(c);return`${h.toFixed(1)} ${f.toFixed(1)}`});n[a].setAttribute("d",`M${l.join("L")}`),n[a].setAttribute("class",o?"thin":""),n[a].style.stroke=r})}drawPoints(t,e,n){let s=nu(this.points,"circle",e.length);e.forEach((r,o)=>{let a=s[o];a.setAttribute("r","5");let{x:l,y:c,visible:h}=t.project(r.at);a.setAttribute("cx",l.toFixed(1)),a.setAttribute("cy",c.toFixed(1)),a.setAttribute("class",`${r.isMoved?"moved":""} ${r.name===n?"selected":""} ${h?"":"hidden"}`),a.dataset.point=r.name})}drawNames(t,e){let n=[],s=e.flatMap(({at:o,text:a})=>{let l=t.project(o),c=6.6*a.length,f=LS.map(([g,x])=>[l.x+(g>0?fm:-fm-c),l.y+x*pm]).find(([g,x])=>g>0&&g+c<this.width&&!n.some(([m,_,v])=>g<_&&g+c>m&&Math.abs(x-v)<pm));if(!l.visible||!f)return[];let[u,d]=f;return n.push([u,u+c,d]),[{x:u,y:d,text:a}]}),r=nu(this.names,"text",s.length);s.forEach(({x:o,y:a,text:l},c)=>{r[c].setAttribute("x",o.toFixed(1)),r[c].setAttribute("y",(a+4).toFixed(1)),r[c].textContent!==l&&(r[c].textContent=l)})}drawMotion(t,e){this.motion.replaceChildren(...e.flatMap(({at:n,by:s})=>{let[r,o]=[t.project(n),t.project(n.clone().add(s))];return this.arrow(r.x,r.y,o.x,o.y,8)}))}drawImpulses(t,e){this.impulses.replaceChildren(...e.map(({at:n,by:s,title:r})=>{let[o,a]=[t.project(n),t.project(n.clone().add(s))],l=ue("g",{"data-impulse":r});return ue("title",{},l).textContent=r,l.append(...this.arrow(o.x,o.y,a.x,a.y,10)),l}))}drawDirections(t,e,n){let s=[];n.forEach(({half:r,label:o,isBounded:a},l)=>{let c=n[(l+1)%n.length];if(a&&c.isBounded){let d=Array.from({length:49},(g,x)=>{let m=2*Math.PI*x/48,_=e.clone().addScaledVector(r,Math.cos(m)).addScaledVector(c.half,Math.sin(m)),{x:v,y:w}=t.project(_);return`${v.toFixed(1)} ${w.toFixed(1)}`});s.push(ue("path",{d:`M${d.join("L")}Z`}))}let[h,f]=[-1,1].map(d=>t.project(e.clone().addScaledVector(r,d)));s.push(ue("line",{x1:h.x,y1:h.y,x2:f.x,y2:f.y,class:a?"":"open"}));let u=ue("text",{x:f.x+4,y:f.y-4});u.textContent=o,s.push(u)}),this.directions.replaceChildren(...s)}arrow(t,e,n,s,r){let o=Math.hypot(n-t,s-e);if(o<2)return[];let a=Math.min(r,o/2),[l,c]=[(n-t)/o,(s-e)/o],[h,f]=[n-a*l,s-a*c],u=.38*a;return[ue("line",{x1:t,y1:e,x2:h,y2:f}),ue("polygon",{points:`${n},${s} ${h-u*c},${f+u*l} ${h+u*c},${f-u*l}`})]}drawContact(t,e){if(!e){this.contact.replaceChildren();return}let n=e.point.clone().addScaledVector(e.normal,DS*t.pixel(e.point)),[s,r]=[t.project(e.point),t.project(n)],o=Math.hypot(r.x-s.x,r.y-s.y)<12,a=o?[ue("circle",{cx:s.x,cy:s.y,r:11,class:"facing"})]:this.arrow(s.x,s.y,r.x,r.y,NS),l=ue("circle",{cx:s.x,cy:s.y,r:5.5,class:"dot"}),c=ue("circle",{cx:s.x,cy:s.y,r:11,class:"grip","data-contact":"point"}),h=ue("circle",{cx:r.x,cy:r.y,r:11,class:"grip","data-contact":"normal"}),f=8.2*e.label.length+18,{width:u,height:d}=this,g=Math.hypot(r.x-s.x,r.y-s.y),[x,m]=o||g===0?[1,-.6]:[(r.x-s.x)/g,(r.y-s.y)/g],_=Math.min(Math.max(r.x+x*(f/2+14)-f/2,6),u-f-6),v=Math.min(Math.max(r.y+m*28-13,48),d-60),w=e.reach&&t.project(e.reach);if(w&&Math.hypot(w.x-s.x,w.y-s.y)>3&&a.unshift(ue("line",{x1:w.x,y1:w.y,x2:s.x,y2:s.y,class:"reach"})),e.far){let P=t.project(e.far);a.unshift(ue("line",{x1:P.x,y1:P.y,x2:s.x,y2:s.y,class:"rope"}),ue("circle",{cx:P.x,cy:P.y,r:3.5,class:"dot"}))}let M=ue("g",{transform:`translate(${_.toFixed(1)},${v.toFixed(1)})`,class:"chip"});return ue("rect",{width:f.toFixed(0),height:26,rx:5},M),ue("text",{x:(f/2).toFixed(1),y:18,"text-anchor":"middle"},M).textContent=e.label,this.contact.setAttribute("class",`contact ${e.isStale?"stale":""}`),this.contact.replaceChildren(...a,l,...o?[c]:[h,c],M),n}drawLabel(t,e=0,n=0,s){if(!t){this.label.replaceChildren();return}let r=7.1*t.length+14,o=this.width,a=Math.min(Math.max(e+12,4),Math.max(4,o-r-4)),l=Math.max(n-30,4),c=s?[ue("line",{x1:e,y1:n,x2:s.x,y2:s.y,class:"bad"})]:[],h=ue("g",{transform:`translate(${a.toFixed(1)},${l.toFixed(1)})`});ue("rect",{width:r.toFixed(0),height:22,rx:4},h),ue("text",{x:7,y:15.5},h).textContent=t,this.label.replaceChildren(...c,h)}drawAxes(t,e){let{bottom:n}=this,[s,r]=[44,n-76],o=t.camera.matrixWorldInverse,a=`${n} ${e.join()} ${o.elements.slice(0,11).join()}`;if(a===this.drawnAxes)return;this.drawnAxes=a;let l=["x","y","z"].flatMap((c,h)=>{let f=new R(...[0,1,2].map(x=>x===h?e[h]:0)).transformDirection(o);if(Math.hypot(f.x,f.y)<.15)return[];let[u,d]=[s+26*f.x,r-26*f.y],g=ue("text",{x:s+36*f.x,y:r-36*f.y+4,"text-anchor":"middle"});return g.textContent=c,[...this.arrow(s,r,u,d,7),g]});this.axes.replaceChildren(...l)}drawScale(t,e,n){if(!n){this.scale.replaceChildren();return}let{width:s,bottom:r}=this,o=t.pixel(e),a=mm.find(u=>u/o>60)??mm.at(-1),l=a/o,[c,h]=[s-l-18,r-24],f=ue("text",{x:c+l/2,y:h-7,"text-anchor":"middle"});f.textContent=a<1?`${a*1e3} mm`:`${a} m`,this.scale.replaceChildren(ue("path",{d:`M${c} ${h-4}v8M${c} ${h}h${l}M${c+l} ${h-4}v8`}),f)}};var gm=.002,_m=.08,OS=120,xm=8,US=8,Il=class{constructor(t,e,n){this.drivers=t;this.link=e;this.point=n}drivers;link;point;driver;known;ends=[0,0];place(t){return ae(t,this.link,this.point)}async probe(t){let e=E.frames,n=t.project(this.place(e)),s=xm;for(let r of this.drivers.slice(0,US)){let o=E.positionOf(r),a=gm*(r.range[1]-r.range[0]),l=o+a,c=await E.framesAt(r,l);if(c||(l=o-a,c=await E.framesAt(r,l)),!c)continue;let h=t.project(this.place(c)),f=Math.hypot(h.x-n.x,h.y-n.y)/gm;if(f<s)continue;s=f;let u=E.curve&&"ok"in E.curve?E.curve.ok.rows:[],d=cc(u,o);if(this.ends=d&&E.driver===r?[u[d[0]].at,u[d[1]].at]:r.range,this.driver=r,this.known=[{value:l,frames:c},{value:o,frames:e}],f>OS)return}}toward(t,e){let{driver:n}=this;if(!this.known||!n)return;let s=n.range[1]-n.range[0],r=E.answered&&E.positionOf(n),o=this.known[1];r!==void 0&&E.answered===E.study&&Math.abs(r-o.value)>1e-6*s&&(this.known=[o,{value:r,frames:E.frames}]);let[a,l]=this.known,[c,h]=[t.project(this.place(a.frames)),t.project(this.place(l.frames))],f=l.value-a.value,[u,d]=[(h.x-c.x)/f,(h.y-c.y)/f],g=u*u+d*d;if(g*s*s<xm**2)return;let x=((e.x-h.x)*u+(e.y-h.y)*d)/g,m=Math.min(Math.max(x,-_m*s),_m*s),_=Math.min(Math.max(l.value+m,this.ends[0]),this.ends[1]);E.change(on(E.study,n,_),`drag ${E.scene.links[this.link].name}`)}};var FS={mouse:12,touch:24},kS=6,ym=4,vm=.001,BS=.1,zS=.25,VS=.003,GS=400,Ll=class{constructor(t,e){this.element=t;this.picked=e;let n=document.createElement("div");n.className="surface",t.append(n);try{this.renderer=new xl({antialias:!0,alpha:!0}),this.renderer.debug.checkShaderErrors=!1,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.domElement.addEventListener("webglcontextlost",r=>{r.preventDefault(),this.renderer=void 0,this.webgl=!1,E.set({notice:"The graphics of this browser stopped; the mechanism is drawn as lines."})}),n.append(this.renderer.domElement)}catch{this.webgl=!1}this.stage.add(new br("#ffffff","#aab4c0",2.2),new wr("#ffffff",.35));let s=new Mr("#ffffff",1.6);s.position.set(3,4,6),this.stage.add(s),this.cameras=new Rl(n,()=>this.invalidate()),this.overlay=new Pl(t),this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(t),n.addEventListener("pointerdown",this.down,{capture:!0}),n.addEventListener("pointermove",this.move),n.addEventListener("pointerup",this.up),n.addEventListener("pointercancel",this.cancel),n.addEventListener("pointerleave",()=>this.hover(void 0)),addEventListener("keydown",this.key),this.stop=E.listen(()=>this.invalidate()),this.resize()}element;picked;webgl=!0;renderer;stage=new cr;grid;bodies;cameras;overlay;shown={};shapes=[];centre=new R;radius=1;tip;drag;press;pointer;hovered;box=new DOMRect;pending=!1;rendered=[];times=[];stop;observer;dispose(){this.stop(),this.observer.disconnect(),removeEventListener("keydown",this.key),this.bodies?.dispose(),this.renderer?.dispose(),this.element.replaceChildren()}png(){if(this.renderer)return this.rendered=[],this.draw(),this.renderer.domElement.toDataURL("image/png")}fit(){let{scene:t,frames:e,posed:n}=E;if(!t||!e)return;let s=Vh(t,e,this.shapes);if(n){let o=new R(...n.report.contact.point_world);s.push(o,o.clone().addScaledVector(new R(...n.report.contact.normal_world),zS*this.radius))}let r=this.farEnd(e);r&&s.push(r),this.cameras.fit(s),this.invalidate()}resize(){let{clientWidth:t,clientHeight:e}=this.element;!t||!e||(this.renderer?.setSize(t,e),this.rendered=[],this.cameras.resize(t,e),this.overlay.resize(t,e),!this.shown.fitted&&this.shown.scene&&this.fit(),this.invalidate())}invalidate(){this.pending||(this.pending=!0,requestAnimationFrame(()=>{this.pending=!1;let t=performance.now();this.draw(),this.times.push(performance.now()-t),this.times.length>GS&&this.times.shift()}))}build(t){let e=this.shown.fitted!==E.opened;if((this.shown.shapes!==E.shapes||e)&&(this.shapes=(E.shapes??[]).map(vp),this.shown.shapes=E.shapes,E.answers.facets=bp(t,this.shapes)),this.bodies&&this.stage.remove(this.bodies.group),e){let n=Vh(t,t.design,this.shapes),s=n.reduce((o,a)=>o.clone().min(a),n[0]),r=n.reduce((o,a)=>o.clone().max(a),n[0]);this.centre=s.clone().add(r).multiplyScalar(.5),this.radius=r.distanceTo(s)/2||eu,this.shown.fitted=E.opened,this.fit(),this.addGrid(t)}this.bodies=new El(t,this.shapes,this.radius,this.bodies),this.stage.add(this.bodies.group),this.shown.scene=t}addGrid(t){this.grid&&(this.stage.remove(this.grid),this.grid.dispose());let e=10**Math.floor(Math.log10(this.radius)),n=Math.ceil(2.2*this.radius/e)*e,s=matchMedia("(prefers-color-scheme: dark)").matches;this.grid=new Ar(2*n,Math.round(2*n/e),...s?["#48525e","#2c343d"]:["#b8c1cc","#dde2e8"]),this.grid.rotation.x=Math.PI/2;let r=t.wheels[0],o=r?ae(t.design,r.link,r.centre).z-r.radius:this.centre.z-.75*this.radius;this.grid.position.set(Math.round(this.centre.x/e)*e,Math.round(this.centre.y/e)*e,o),this.stage.add(this.grid)}draw(){let{scene:t,frames:e,posed:n,problem:s}=E;if(!t||!e)return;let r=this.shown.scene===t?void 0:this.bodies;this.shown.scene!==t&&this.build(t),this.shown.view!==E.view&&(this.shown.view=E.view,this.cameras.show(E.view),this.grid&&(this.grid.visible=E.view==="3d"));let o=E.answered?.pose.file;if(this.shown.pose!==o&&E.answered===E.study&&(this.shown.pose=o,this.fit()),E.isIdle&&n){let{x:u,y:d}=this.cameras.project(new R(...n.report.contact.point_world)),g=u>0&&d>0&&u<this.element.clientWidth&&d<this.element.clientHeight,x=!g&&this.shown.isInside&&this.shown.answered!==E.answered;x&&this.fit(),this.shown.isInside=g||x,this.shown.answered=E.answered}let a=this.bodies;a.pose(e);let l=n?.report.bodies.map(u=>u.share),c=Math.max(1e-12,...(l??[]).map(u=>u??0)),f=E.colours==="share"&&l?.some(u=>u!==null)&&!s?t.links.map((u,d)=>Xi((l[d]??0)/c)):null;a.colour(f,void 0),this.colourMap(),a.outlines(E.showsDesign,E.variants.filter(u=>u.study!==E.answered)),this.render(),r?.dispose(),this.overlay.drawWires(this.cameras,a.wires(e,f,!this.webgl)),this.overlay.drawAxes(this.cameras,E.axes),this.overlay.drawScale(this.cameras,this.centre,E.view!=="3d"),this.overlay.drawPoints(this.cameras,E.showsPoints?this.marks():[],E.selected),this.overlay.drawNames(this.cameras,E.showsNames&&n&&!s?this.names(e):[]),this.overlay.drawImpulses(this.cameras,s?[]:sm(this.radius)),this.overlay.drawDirections(this.cameras,n?new R(...n.report.contact.point_world):this.centre,s?[]:rm(this.radius)),this.overlay.drawMotion(this.cameras,E.showsMotion&&n&&!s?this.motion(e):[]),this.tip=this.overlay.drawContact(this.cameras,n&&{point:new R(...n.report.contact.point_world),normal:new R(...n.report.contact.normal_world),reach:this.reach(e),far:this.farEnd(e),label:this.value(),isStale:s!==void 0}),this.drawLabel()}render(){let{camera:t}=this.cameras;t.updateMatrixWorld();let e=[E.scene,E.frames,E.posed,E.problem,E.colours,E.showsDesign,E.variants,E.answered,this.shown.map,...t.projectionMatrix.elements,...t.matrixWorld.elements];e.length===this.rendered.length&&e.every((n,s)=>n===this.rendered[s])||(this.rendered=e,this.renderer?.render(this.stage,t))}reach(t){let{scene:e,posed:n}=E,{link:s,point_world:r}=n.report.contact,o=e.links.findIndex(c=>c.name===s);if(o<0||this.shapes[o]?.length)return;let a=new R(...r);return e.links[o].lines.map(([c,h])=>new Er(ae(t,o,c),ae(t,o,h)).closestPointToPoint(a,!0,new R)).sort((c,h)=>c.distanceTo(a)-h.distanceTo(a))[0]}farEnd(t){let e=E.study?.contact.along_line,n=E.scene.links.findIndex(s=>s.name===e?.link);return e&&n>=0?ae(t,n,e.point):void 0}names(t){let{scene:e,posed:n}=E;return e.links.flatMap((s,r)=>{let o=n.report.bodies[r]?.share??0;return o>=VS&&s.com?[{share:o,at:ae(t,r,s.com),text:`${Xt(s.name)} ${Ot(100*o,o<.095?1:0)} %`}]:[]}).sort((s,r)=>r.share-s.share)}value(){let{report:t}=E.posed;if(t.status==="immovable")return"m̄ = ∞";if(t.status==="massless")return`m̄ = 0 ${t.unit}`;let e=t.named_contact;return e?`${Xt(e.name)}${e.brought_to_touch?", at the touch":""}`:`m̄ ${Nn(t.effective_mass,t.effective_mass_error)} ${t.unit}`}marks(){let{scene:t,frames:e}=E;return(t?.sheet?.hardpoints??[]).map(n=>({name:n.name,at:ae(e,n.link,n.point),isMoved:E.moved(n.name).some(s=>s!==0)}))}motion(t){let{scene:e,posed:n}=E,s=Math.max(1e-12,...n.velocities.map(o=>o?Math.hypot(...o):0)),r=.35*this.radius/s;return e.links.flatMap((o,a)=>{let l=n.velocities[a];return!o.com||!l||Math.hypot(...l)<1e-6*s?[]:[{at:ae(t,a,o.com),by:new R(...l).multiplyScalar(r)}]})}colourMap(){let t=E.answers.isShown("map")?E.answers.results.map:void 0,e=t&&"ok"in t?t.ok:void 0;this.shown.map===e&&this.shown.mapped===this.bodies||(this.shown.map=e,this.shown.mapped=this.bodies,this.bodies.paint(e&&om(e)))}drawLabel(){let t=this.drag?.what==="point"?this.drag.name:this.hovered??E.selected,e=t?this.marks().find(a=>a.name===t):void 0;if(!e||!E.showsPoints){this.overlay.drawLabel(void 0);return}let n=E.moved(e.name).map(a=>a*1e3),s=n.some(a=>a!==0)?`  Δ ${n.map(a=>De(a,1)).join(" ")} mm`:"",r=this.cameras.project(e.at),o=E.problem&&this.drag?.what==="point"&&this.pointer?this.pointer:void 0;this.overlay.drawLabel(e.name+s,r.x,r.y,o)}at(t){return this.drag||(this.box=this.element.getBoundingClientRect()),{x:t.clientX-this.box.left,y:t.clientY-this.box.top}}hit(t,e,n){let s=FS[n==="mouse"?"mouse":"touch"],r=[],o=(a,l,c,h=0)=>{let f=this.cameras.project(c),u=Math.hypot(f.x-t,f.y-e)+h;f.visible&&u<s&&r.push({what:a,name:l,d:u})};if(E.posed&&(this.tip&&o("normal","normal",this.tip,-2),o("contact","contact",new R(...E.posed.report.contact.point_world),-kS)),E.showsPoints)for(let a of this.marks())o("point",a.name,a.at);return r.sort((a,l)=>a.d-l.d)[0]}down=t=>{if(t.button!==0||!E.frames)return;let{x:e,y:n}=this.at(t);if(this.press={x:e,y:n},E.choosing)return;let s=this.hit(e,n,t.pointerType)??this.linkAt(e,n);if(!s)return;this.cameras.enable(!1),t.stopImmediatePropagation(),t.currentTarget.setPointerCapture(t.pointerId);let r=s.what==="point"?this.marks().find(a=>a.name===s.name):void 0,o=E.posed?.report.contact;if(s.pull){let{pull:a}=s;this.drag={what:"link",name:s.name,held:null,moved:!1,frames:E.frames,hadProblem:!1,at:a.place(E.frames),start:[0,0,0],pull:a},E.begin(`drag ${s.name}`),a.probe(this.cameras);return}this.drag={...s,held:null,moved:!1,frames:E.frames,hadProblem:E.problem!==void 0,at:r?r.at:s.what==="normal"?this.tip.clone():new R(...o.point_world),start:r?E.moved(s.name):s.what==="normal"?o.normal_world:o.point_link},E.begin(s.what==="point"?`move ${s.name}`:s.what==="normal"?"turn the normal":"move the contact"),r&&E.set({selected:s.name})};move=t=>{let e=this.at(t);if(this.pointer=e,!this.drag){t.pointerType==="mouse"&&t.buttons===0&&this.hover(this.hit(e.x,e.y,"mouse"));return}!this.drag.moved&&this.press&&Math.hypot(e.x-this.press.x,e.y-this.press.y)<ym||(this.drag.moved=!0,this.drag.pull?this.drag.pull.toward(this.cameras,e):this.drag.what==="point"?this.dragPoint(e,t.altKey):this.drag.what==="contact"?this.dragContact(e):this.dragNormal(e),this.invalidate())};linkAt(t,e){let n=this.bodies&&this.cast(t,e),s=n?sd(E.scene,E.drivers,n.link):[];if(!n||!s.length)return;let r=n.at.clone().applyMatrix4(Mn(E.frames,n.link).invert());return{what:"link",name:E.scene.links[n.link].name,pull:new Il(s,n.link,r.toArray())}}hover(t){let e=t?.what==="point"?t.name:void 0;this.element.style.cursor=E.choosing?"crosshair":t?"grab":"",e!==this.hovered&&(this.hovered=e,this.invalidate())}dragPoint({x:t,y:e},n){let s=this.drag,r=E.opened.scene.sheet.hardpoints.find(h=>h.name===s.name),o=this.cameras.inPlane(t,e,s.at).sub(s.at),a=Us(s.frames,r.link,o).transformDirection(this.designTurn(r.link)).multiplyScalar(o.length()),l=n?vm/10:vm,c=[0,1,2].map(h=>{let f=a.getComponent(h)*r.to_world[h];return s.held&&"xyz"[h]!==s.held?s.start[h]:Math.round((s.start[h]+f)/l)*l});E.movePoint(s.name,c,`move ${s.name}`)}designTurn(t){let e=E.opened.scene.design.slice(12*t,12*t+9);return new Qt().set(e[0],e[1],e[2],0,e[3],e[4],e[5],0,e[6],e[7],e[8],0,0,0,0,1)}dragContact({x:t,y:e}){let n=E.study?.contact,s=n?.along_line&&!n.frame?n:E.ownContact();if(!s?.link)return;let r=E.scene.links.findIndex(l=>l.name===s.link),o=this.shapes[r]?.length?this.cast(t,e,r):void 0,a={...s};o&&(a.point=this.pointIn(r,o.at)),o&&!s.along_line?(a.normal=this.normalIn(r,o.normal),delete a.normal_frame):o||(a.point=this.pointIn(r,this.cameras.inPlane(t,e,this.drag.at))),E.setContact(a,"move the contact")}pointIn(t,e){let n=ae(E.frames,t,[0,0,0]);return Us(E.frames,t,e.clone().sub(n)).toArray().map(s=>Math.round(s*1e4)/1e4+0)}normalIn(t,e){return Us(E.frames,t,e).toArray().map(n=>Math.round(n*1e5)/1e5+0)}dragNormal({x:t,y:e}){let n=E.ownContact();if(!n)return;let s=new R(...E.posed.report.contact.point_world),r=this.drag.at.distanceTo(s),{origin:o,direction:a}=this.cameras.ray(t,e),l=o.clone().addScaledVector(a,s.clone().sub(o).dot(a)),c=l.distanceTo(s),h=l.sub(s);c<r&&h.addScaledVector(a,-Math.sqrt(r*r-c*c)),h.normalize();for(let u of[0,1,2]){let d=new R().setComponent(u,Math.sign(h.getComponent(u))||1);h.angleTo(d)<BS&&h.copy(d)}let f=h.toArray().map(u=>Math.round(u*1e4)/1e4+0);E.setContact({...n,normal:f,normal_frame:"world"},"turn the normal")}cast(t,e,n){let{origin:s,direction:r}=this.cameras.ray(t,e),o=new Tr(s,r);this.bodies.group.updateMatrixWorld(!0);let a=this.bodies.pickable.filter(h=>n===void 0||h.userData.link===n),l=o.intersectObjects(a,!1)[0];if(!l?.face)return;let c=l.face.normal.clone().transformDirection(l.object.matrixWorld);return c.dot(r)>0&&c.negate(),{link:l.object.userData.link,at:l.point,normal:c}}up=t=>{let e=this.at(t),n=this.press&&Math.hypot(e.x-this.press.x,e.y-this.press.y)<ym,s=this.drag;if(this.drag=void 0,this.cameras.enable(!0),s){let o=(s.what==="point"?E.moved(s.name).map((l,c)=>(l-s.start[c])*1e3):[]).map((l,c)=>Math.abs(l)>1e-6?`${De(l,1)} mm ${"xyz"[c]}`:"").filter(Boolean).join(" "),a=o?`${s.name} ${o}`:void 0;s.what==="link"&&n?(E.finish(!1),this.pickAt(e.x,e.y)):s.what==="point"&&!s.hadProblem?E.finishAnswered(s.moved,a):E.finish(s.moved,a)}else if(n&&E.choosing){let r=this.bodies&&this.cast(e.x,e.y);r&&r.link!==E.scene.root&&(E.choosing=!1,this.contactAt(r.link,r.at,r.normal))}else n&&this.bodies&&!this.hit(e.x,e.y,t.pointerType)&&this.pickAt(e.x,e.y);this.press=void 0,this.invalidate()};pickAt(t,e){let n=this.cast(t,e);n?this.picked(n.link,n.at,n.normal):(E.set({selected:void 0}),this.picked(void 0))}cancel=()=>{this.drag&&(this.drag=void 0,this.cameras.enable(!0),E.finish(!1))};key=t=>{if(!this.drag)return;t.key==="Escape"&&this.cancel();let e=t.key.toLowerCase();(e==="x"||e==="y"||e==="z")&&(this.drag.held=this.drag.held===e?null:e)};contactAt(t,e,n){let s=(this.shapes[t]?.length??0)>0;E.setContact({link:E.scene.links[t].name,point:this.pointIn(t,e),normal:s?this.normalIn(t,n):n.toArray().map(r=>Math.round(r*1e4)/1e4+0),...s?{}:{normal_frame:"world"}},`contact on ${E.scene.links[t].name}`)}isSettled(){return!this.pending&&E.isIdle}rested(){return E.rested()}takeTimes(){let t=n=>[...n].sort((s,r)=>s-r)[Math.floor(n.length/2)]??0,e={answer:t(E.times),draw:t(this.times),count:E.times.length};return E.times.length=0,this.times.length=0,e}state(){let{scene:t,frames:e,problem:n,study:s,answers:r,ends:o,variation:a,drivers:l,curve:c}=E;return{scene:t,frames:e,study:s,curve:c,ends:o,variation:a,problem:n?.message,memory:E.engine?.memory,values:Object.fromEntries(l.map(h=>[h.name,E.positionOf(h)])),results:{...r.results,map:void 0}}}linkUnder(t,e){let n=this.element.getBoundingClientRect(),[s,r]=[t-n.left,e-n.top];return this.hit(s,r,"mouse")?void 0:this.cast(s,r)?.link}onScreen(t,e){let n=E.scene.links.findIndex(a=>a.name===t),s=this.element.getBoundingClientRect(),{x:r,y:o}=this.cameras.project(ae(E.frames,n,e));return{x:r+s.left,y:o+s.top}}};var bm=[["3d","3D","3"],["front","Front","F"],["side","Side","S"],["top","Top","T"]];function Sm(){let{failure:i,opened:t,refusal:e}=Zt(),n=sn(null),[s,r]=le(!1);return Qe(()=>{let o=h=>{let f=h.target,u=f.matches("input, select, textarea"),d=u&&f.type==="text"&&(E.inGesture||!f.matches(".number"));if((h.ctrlKey||h.metaKey)&&h.key.toLowerCase()==="z"&&!d)h.preventDefault(),h.shiftKey?E.redo():E.undo();else if((h.ctrlKey||h.metaKey)&&h.key.toLowerCase()==="y"&&!u)h.preventDefault(),E.redo();else if(h.key==="Escape")E.choosing&&E.set({choosing:!1}),E.end();else if(!u&&!h.ctrlKey&&!h.metaKey&&!h.altKey&&!E.inGesture){let g=bm.find(([,,x])=>x===h.key.toUpperCase());g&&E.set({view:g[0]}),h.key==="0"&&n.current?.fit()}},a=h=>{h.preventDefault(),r(!1),h.dataTransfer&&HS(h.dataTransfer)},l=h=>{h.preventDefault(),r(!!h.dataTransfer?.types.includes("Files"))},c=h=>{h.relatedTarget||r(!1)};return addEventListener("keydown",o),addEventListener("drop",a),addEventListener("dragover",l),addEventListener("dragleave",c),()=>{removeEventListener("keydown",o),removeEventListener("drop",a),removeEventListener("dragover",l),removeEventListener("dragleave",c)}},[]),p("div",{class:"page",children:[s?p("div",{class:"drop",children:"Drop a model file or a folder"}):null,p(WS,{}),p(XS,{}),p(Rp,{}),i?p("main",{class:"message",children:p("div",{class:"box bad",children:p("p",{children:[p("b",{children:"No engine."})," ",i]})})}):null,e?p($S,{}):null,p(Lp,{}),t?p("main",{class:"work",children:[p(qS,{view:n}),p(Ap,{}),p("aside",{class:"side","aria-label":"Question and result",children:[p(wp,{}),p(Jp,{}),p(tm,{}),p(Qp,{}),p(Cp,{png:()=>n.current?.png()}),p(jp,{})]})]}):i||e?null:p("main",{class:"message",children:p("p",{class:"soft",children:"The engine starts …"})})]})}async function Mm(i){E.set({notice:void 0}),await E.open({name:i.name,text:await i.text()})}async function HS(i){try{let t=await Xu(i);t.length===1&&!t[0].path.includes("/")?await Mm(t[0].file):t.length&&await E.openFolder(t)}catch(t){E.set({notice:`The dropped folder cannot be read: ${t.message}. Choose it by Folder….`})}}function WS(){let{fileName:i,past:t,future:e,posed:n,problem:s,busy:r,scene:o,variants:a}=Zt(),l=sn(null),c=sn(null);Qe(()=>c.current.setAttribute("webkitdirectory",""),[]);let[h,f]=le(!1),u=i.replace(/.*[\\/]/,"");return p("header",{class:"bar",children:[p("b",{class:"brand",title:"percuss explorer",children:o?.name?Xt(o.name):"percuss explorer"}),p("span",{class:"file",title:o?.name,children:u}),o?.sheet?p("span",{class:"soft sheet-axes",children:o.sheet.axes}):null,p("button",{onClick:()=>l.current.click(),children:"Open…"}),p("input",{ref:l,type:"file",hidden:!0,accept:".urdf,.xml,.mjcf,.sdf,.world,.toml,.csv,.json","aria-label":"Model file",onChange:d=>{let g=d.currentTarget.files?.[0];g&&Mm(g),d.currentTarget.value=""}}),p("button",{onClick:()=>c.current.click(),title:"Opens a folder that has the model with its included files and meshes",children:"Folder…"}),p("input",{ref:c,type:"file",hidden:!0,"aria-label":"Folder with a model",onChange:d=>{let{files:g}=d.currentTarget;g?.length&&E.openFolder(Wu(g)),d.currentTarget.value=""}}),r?p("span",{class:"busy",role:"status",children:["computing … ",p("button",{onClick:()=>{E.end()},children:"End (Esc)"})]}):null,p("span",{class:"grow"}),p("button",{disabled:!t.length,title:t.at(-1)?`Undo ${t.at(-1).label} (Ctrl Z)`:"Undo",onClick:()=>E.undo(),"aria-label":"Undo",children:["↶",p("span",{class:"wide",children:" Undo"})]}),p("button",{disabled:!e.length,title:"Redo (Ctrl Shift Z)",onClick:()=>E.redo(),"aria-label":"Redo",children:["↷",p("span",{class:"wide",children:" Redo"})]}),p("button",{disabled:!n||!!s,onClick:()=>E.freeze(),title:"Keeps the present design for comparison",children:[p("span",{class:"wide",children:"Keep as "}),p("span",{class:"narrow",children:"Keep "}),ho(a)]}),p("button",{onClick:async()=>{history.replaceState(null,"",await Ji(E.linked())),f(await Xr(location.href)),setTimeout(()=>f(!1),1500)},"aria-label":"Copy link",children:h?"Copied":p(jt,{children:[p("span",{class:"wide",children:"Copy link"}),p("span",{class:"narrow",children:"Link"})]})})]})}function XS(){let{notice:i}=Zt();return i?p("p",{class:"notice",role:"status",children:[i," ",p("button",{class:"quiet",onClick:()=>E.set({notice:void 0}),children:"Close"})]}):null}function $S(){let{refusal:i,opened:t}=E;return p("div",{class:t?"refused":"refused alone",role:"alert",children:[p("p",{children:[p("b",{children:"The model is refused."})," ",i.diagnostics.length?"":i.message]}),i.diagnostics.map((e,n)=>p("p",{class:`finding ${e.severity}`,children:[e.path?`${e.path}${e.line?`:${e.line}`:""}: `:"",e.severity,": ",e.message]},n)),t?p("button",{onClick:()=>E.set({refusal:void 0}),children:"Keep the open model"}):null]})}function qS({view:i}){let{view:t,posed:e,problem:n,colours:s,scene:r,showsPoints:o,showsNames:a,showsMotion:l,showsDesign:c}=Zt(),h=sn(null),[f,u]=le();Qe(()=>{let m=new Ll(h.current,(_,v,w)=>u(_===void 0?void 0:{link:_,at:v,normal:w}));return i.current=m,window.percussView=m,()=>m.dispose()},[]);let d=Math.max(0,...e?.report.bodies.map(m=>m.share??0)??[]),g=f&&r?.links[f.link],x=f&&e?.report.bodies[f.link]?.share;return p("section",{class:"stage","aria-label":"Mechanism",children:[p("div",{ref:h,class:"canvas",role:"img","aria-label":ZS()}),p("div",{class:"views",role:"group","aria-label":"View",children:[bm.map(([m,_,v])=>p("button",{"aria-pressed":t===m,title:`${_} (${v})`,onClick:()=>E.set({view:m}),children:_},m)),p("button",{title:"Fit (0)","aria-label":"Fit the view",onClick:()=>i.current?.fit(),children:"⤢"})]}),p("details",{class:"menu",children:[p("summary",{children:"Show"}),p("div",{class:"shows",role:"group","aria-label":"Shown",children:[r?.sheet?p(qi,{on:o,label:"Hardpoints",set:m=>E.set({showsPoints:m})}):null,p(qi,{on:s==="share",label:"Shares",title:"Colours of the links by their shares of m̄",set:m=>E.set({colours:m?"share":"plain"})}),p(qi,{on:a,label:"Names",title:"Names of the links with their shares of m̄",set:m=>E.set({showsNames:m})}),p(qi,{on:l,label:"Motion",title:"Velocities of the centres of mass when the gap closes",set:m=>E.set({showsMotion:m})}),p(qi,{on:c,label:"Design pose",set:m=>E.set({showsDesign:m})}),p(qi,{on:E.answers.isShown("directions"),label:"Directions",title:"Ellipsoid of m̄ over directions at the contact point: its radius is in proportion to √m̄",set:m=>E.answers.show("directions",m)}),E.shapes?.some(m=>m)?p(qi,{on:E.answers.isShown("map"),label:"Map",title:"m̄ of a contact at each facet, along its outward normal",set:m=>E.answers.show("map",m)}):null]})]}),p(YS,{}),!E.answers.isShown("map")&&e?.report.status==="finite"&&d>0&&s==="share"&&!n?p("div",{class:"legend",children:[p("span",{children:"share of m̄ 0"}),p("i",{style:{backgroundImage:`linear-gradient(90deg, ${Gh()})`}}),p("span",{children:[Ot(100*d,0)," %"]})]}):null,g&&f?p("div",{class:"picked",role:"dialog","aria-label":g.name,children:[p("b",{children:g.name}),p("span",{class:"soft",children:[g.mass>0?`${Ot(g.mass,3)} kg`:"no mass",x?` · ${Ot(100*x,1)} % of m̄`:""]}),f.link===r.root?null:p("button",{onClick:()=>{i.current.contactAt(f.link,f.at,f.normal),u(void 0)},children:"Contact here"}),p("button",{class:"quiet","aria-label":"Close",onClick:()=>u(void 0),children:"×"})]}):p(Pp,{})]})}function YS(){let i=E.answers.results.map;if(!E.answers.isShown("map"))return null;if(!i)return p("div",{class:"legend",children:"computing the map …"});if("refused"in i)return p("div",{class:"legend",children:i.refused.message});let t=Zh(i.ok);return t?p("div",{class:"legend","data-map":t.join(" "),children:[p("span",{children:["m̄ ",Jt(t[0],3)]}),p("i",{style:{backgroundImage:`linear-gradient(90deg, ${Gh()})`}}),p("span",{children:[Jt(t[1],3)," kg"]})]}):p("div",{class:"legend",children:"no facet has a finite m̄"})}function qi({on:i,label:t,title:e,set:n}){return p("button",{"aria-pressed":i,title:e,onClick:()=>n(!i),children:t})}function ZS(){let{scene:i,posed:t}=E;if(!i)return"Mechanism";let e=t?.report.contact,n=e?`; contact on ${e.link} at ${e.point_world.map((s,r)=>Ot(s*E.axes[r]*1e3,0)).join(", ")} mm`:"";return`${i.name}: ${i.links.length} links, ${i.joints.length} joints, ${i.closures.length} loop closures${n}`}var KS=JSON.parse(document.getElementById("start").textContent||"{}"),wm=document.getElementById("app");wm.replaceChildren();Eu(p(Sm,{}),wm);E.start(KS);})();
